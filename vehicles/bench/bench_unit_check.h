#pragma once

#include <span>
#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/bench/bench_damper.h"

namespace fourpost {

/// Checks whether a unit is off by a thousand, e.g. mm declared as m or kN as N, at any stroke. It is if, at these
/// values of all parameters, the damper would give 30 times more or less force (rms) for that motion, and a force
/// within a factor of 5.6 for a motion a thousandth or a thousand times as large. The file's values are guesses, but
/// not that far off, and no damper law hides it: force follows velocity, and friction alone is not a thirtieth of its
/// value. Reports an error and returns false in that case.
bool CheckBenchUnits(const BenchDamper& damper, const BenchMotion& motion, std::span<const double> force,
                     std::span<const double> values, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
