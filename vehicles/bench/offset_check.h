#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "analysis/diagnostics.h"
#include "analysis/low_pass.h"
#include "vehicles/bench/bench_damper.h"

namespace fourpost {

/// Looks at what offsets of the sensors would leave, as warnings, against the damper at these values of all parameters.
/// Of the force: its mean where the displacement turns back, at rest, is off the modelled one by more than 15 % of
/// the force's span; not of a damper with gas or springs beside it, whose preload a fit finds. Of the displacement: its
/// mean is more than its span, and the damper's force is another one there, as by springs, gas or chambers of oil; a
/// damper's laws of speed do not know where it is. `filter`: of the rig, through which the force has passed and which
/// has settled at sample `first`.
void CheckBenchOffsets(const BenchDamper& damper, const BenchMotion& motion, const std::optional<LowPass>& filter,
                       std::span<const double> force, std::size_t first, std::size_t end,
                       std::span<const double> values, const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
