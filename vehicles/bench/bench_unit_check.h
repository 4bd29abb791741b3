#pragma once

#include <span>
#include <string>

#include "analysis/diagnostics.h"
#include "vehicles/bench/bench_damper.h"

namespace fourpost {

/// Looks whether a recording is off by a thousand, as of mm told as m or kN told as N, at whatever stroke: a fault
/// where the damper at these values of all parameters would give 30 times more or less force (rms) for that motion, and
/// comes within a factor of 5.6 of it for one a thousandth or a thousand times as large. A file's values are guesses,
/// but not by so much, and no law of a damper hides it: force follows speed, and friction alone is no thirtieth of what
/// it was. False when there was a fault.
bool CheckBenchUnits(const BenchDamper& damper, const BenchMotion& motion, std::span<const double> force,
                     std::span<const double> values, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
