#pragma once

#include <functional>
#include <vector>

#include "analysis/diagnostics.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// An error for each loop closure that stays open in the pose where an assembly gave up; one at least.
/// `distance`: of two points in that pose [m].
Diagnostics LoopGapFaults(const Vehicle& vehicle, const std::vector<double>& rod_lengths,
                          const std::function<double(const Point&, const Point&)>& distance);

}  // namespace fourpost
