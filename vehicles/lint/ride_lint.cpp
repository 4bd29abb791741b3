#include "vehicles/lint/ride_lint.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "vehicles/lint/findings.h"
#include "vehicles/ride/stability.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {
namespace {

/// With three digits.
std::string Short(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

void LintStability(const VehicleSummary& summary, FileFaults& findings) {
  const std::optional<Growth> growth = GrowthOf(summary.modes, summary.growth_rate);
  if (!growth) return;
  findings.Report(kVehicleUnstable, 0, {growth->Text()});
}

void LintWheelRates(const Vehicle& vehicle, const VehicleSummary& summary, FileFaults& findings) {
  for (std::size_t i = 0; i < summary.ride.wheels.size(); ++i) {
    const WheelRates& rates = summary.ride.wheels[i];
    const double rate = rates.alone.wheel_Npm;
    // A suspension stiffer than its tyre is none.
    if (!std::isfinite(rate) || (rate >= 0 && !(rate > rates.tyre_Npm && rates.tyre_Npm > 0))) continue;
    const std::string& name = summary.suspension.wheels[i].name;
    const auto tyre = std::find_if(vehicle.tyres.begin(), vehicle.tyres.end(),
                                   [&](const Tyre& candidate) { return candidate.name == name; });
    findings.Report(rate < 0 ? kWheelRateNegative : kWheelRateHigh, tyre->source_line,
                    {name, Short(rate / 1e3) + " N/mm"});
  }
}

void LintRatio(const StrutGeometry& strut, const std::string& element, int line, FileFaults& findings) {
  // Of coils, dampers and pushrods in cars some 0.3 to 1.3.
  constexpr double kLeast = 0.1;
  constexpr double kMost = 2.5;
  if (!strut.alone || strut.wheel < 0) return;
  const double ratio = std::abs(*strut.alone);
  if (ratio >= kLeast && ratio <= kMost) return;
  findings.Report(kMotionRatio, line, {element, Short(*strut.alone), ratio < kLeast ? " and its axis" : ""});
}

}  // namespace

Diagnostics LintRide(const Vehicle& vehicle, const VehicleSummary& summary) {
  Diagnostics findings;
  FileFaults file(vehicle.file, findings);
  file.SetTwins(vehicle.twins);
  LintStability(summary, file);
  LintWheelRates(vehicle, summary, file);
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i)
    if (vehicle.springs[i].kind == Spring::Kind::kCoil)
      LintRatio(summary.ride.springs[i], vehicle.springs[i].Element(), vehicle.springs[i].source_line, file);
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    LintRatio(summary.ride.dampers[i], "fp:damper '" + vehicle.dampers[i].name + "'", vehicle.dampers[i].source_line,
              file);
  return findings;
}

}  // namespace fourpost
