#include "vehicles/bench/bench_unit_check.h"

#include <cmath>
#include <vector>

#include "analysis/signals/deviation.h"
#include "analysis/text/short_number.h"

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
    const bool large = factor < 1;
    diagnostics.Error(
        file, 0,
        "has a force of " + ShortNumber(recorded) + " N rms for a motion of " + ShortNumber(DeviationOf(motion.rate)) +
            " m/s rms, for which the damper would give " +
            (std::isfinite(here) ? ShortNumber(here) + " N" : "more than its chambers allow") +
            " at the values of the " + "vehicle file: " +
            (large ? "displacement looks like mm told as m, or force like kN told as N"
                   : "displacement looks like m told as mm, or force like N told as kN") +
            "; correct the row of units, or the values in the vehicle file if they are off by a thousand");
    return false;
  }
  return true;
}

}  // namespace fourpost
