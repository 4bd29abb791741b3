#pragma once

#include <vector>

#include "identify/experiments/covered_ranges.h"
#include "identify/experiments/time_history/history_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How far the vehicle, at these values of its parameters, goes on the recorded posts. Frequencies are those between
/// which the posts have 98 % of the power of their speeds. `steps_s`: see HistorySimulation, one per history.
CoveredRanges CoveredByHistories(const Vehicle& vehicle, const std::vector<double>& values,
                                 const std::vector<MeasuredHistory>& histories, const std::vector<double>& steps_s);

}  // namespace fourpost
