#include "identify/command_line/ride_text.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/text/text_table.h"
#include "vehicles/requests/ride_tables.h"

namespace fourpost {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string Shown(double value, int digits = 3) { return std::isfinite(value) ? Rounded(value, digits) : "-"; }

}  // namespace

std::string RideText(const RideAnswer& ride) {
  std::string text = ride.motion + ": " + RideMethod(ride) + '\n';
  for (const RideTable& shown : RideTables(ride)) {
    TextTable table(shown.head);
    for (const std::vector<std::string>& row : shown.rows) table.Add(row);
    text += table.Format() + (shown.foot.empty() ? "" : shown.foot + '\n') + '\n';
  }
  return text + RideFoot(ride);
}

std::string RideDifferenceText(const RideAnswer& spectra, const RideAnswer& history) {
  TextTable table({spectra.motion, "spectra", "time history", "difference, %"});
  const auto add = [&](const std::string& name, double a, double b) {
    if (a > 0 && b > 0) table.Add({name, Shown(a), Shown(b), Shown(1e2 * (a / b - 1), 2)});
  };
  for (std::size_t i = 0; i < spectra.metrics.comfort.size(); ++i)
    add(spectra.metrics.comfort[i].point + " a_w, m/s^2", spectra.metrics.comfort[i].weighted.rms,
        history.metrics.comfort[i].weighted.rms);
  for (std::size_t i = 0; i < spectra.metrics.wheels.size(); ++i)
    add(spectra.metrics.wheels[i].tyre + " CPLV, %", 1e2 * spectra.metrics.wheels[i].Variation(),
        1e2 * history.metrics.wheels[i].Variation());
  for (std::size_t i = 0; i < spectra.metrics.struts.size(); ++i)
    add(spectra.metrics.struts[i].damper + " travel, mm rms", 1e3 * spectra.metrics.struts[i].travel_rms_m,
        1e3 * history.metrics.struts[i].travel_rms_m);
  if (spectra.metrics.body) {
    add("heave, mm rms", 1e3 * spectra.metrics.body->heave_rms, 1e3 * history.metrics.body->heave_rms);
    add("pitch, deg rms", spectra.metrics.body->pitch_rms / kDegree, history.metrics.body->pitch_rms / kDegree);
    add("roll, deg rms", spectra.metrics.body->roll_rms / kDegree, history.metrics.body->roll_rms / kDegree);
  }
  return table.Format();
}

}  // namespace fourpost
