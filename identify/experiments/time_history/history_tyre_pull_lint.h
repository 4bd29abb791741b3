#pragma once

#include <span>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/history_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Tyres with liftoff="false" that pull on the ground when the vehicle, at these values of its parameters, goes through
/// the recorded histories: one warning each and recording. `steps_s`: of each history, see HistorySimulation.
void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                   const std::vector<MeasuredHistory>& histories, const std::vector<double>& steps_s,
                   Diagnostics& diagnostics);

}  // namespace fourpost
