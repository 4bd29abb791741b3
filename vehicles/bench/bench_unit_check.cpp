#include "vehicles/bench/bench_unit_check.h"

#include <cmath>
#include <vector>

#include "analysis/signals/deviation.h"
#include "analysis/text/short_number.h"
#include "vehicles/bench/findings.h"

namespace fourpost {
namespace {

/// Decades.
constexpr double kFarOff = 1.5;
constexpr double kNear = 0.75;

BenchMotion Scaled(BenchMotion motion, double factor) {
  for (std::vector<double>* signal : {&motion.extension, &motion.rate, &motion.acceleration})
    for (double& value : *signal) value *= factor;
  return motion;
}

}  // namespace

bool CheckBenchUnits(const BenchDamper& damper, const BenchMotion& motion, std::span<const double> force,
                     std::span<const double> values, const std::string& file, Diagnostics& diagnostics) {
  const double recorded = DeviationOf(force);
  const auto modelled = [&](double factor) { return DeviationOf(damper.Tensions(Scaled(motion, factor), values)); };
  /// NaN where a chamber closes.
  const double here = modelled(1);
  const double decades = std::log10(recorded / here);
  if (std::abs(decades) < kFarOff) return true;
  for (const double factor : {1e-3, 1e3}) {
    // The wrong way.
    if (std::isfinite(decades) && (decades > 0) != (factor > 1)) continue;
    if (!(std::abs(std::log10(recorded / modelled(factor))) < kNear)) continue;
    diagnostics.Report(factor < 1 ? kBenchUnitsTooLarge : kBenchUnitsTooSmall, {file},
                       {ShortNumber(recorded) + " N", ShortNumber(DeviationOf(motion.rate)) + " m/s",
                        std::isfinite(here) ? ShortNumber(here) + " N" : "more than its chambers allow"});
    return false;
  }
  return true;
}

}  // namespace fourpost
