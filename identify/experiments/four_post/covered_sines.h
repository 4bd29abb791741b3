#pragma once

#include <vector>

#include "identify/experiments/covered_ranges.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How far the vehicle, at these values of its parameters, goes when it answers the recorded stepped sines.
CoveredRanges CoveredBySines(const Vehicle& vehicle, const std::vector<double>& values,
                             const std::vector<MeasuredRun>& runs);

}  // namespace fourpost
