#pragma once

#include <span>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/four_post_data.h"
#include "identify/history_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Tyres with liftoff="false" that pull on the ground when the vehicle, at these values of its parameters, goes through
/// what was recorded, one warning each and recording.
void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values, const std::vector<MeasuredRun>& runs,
                   Diagnostics& diagnostics);

/// Likewise over time. `steps_s`: of each history, see HistorySimulation.
void LintTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                   const std::vector<MeasuredHistory>& histories, const std::vector<double>& steps_s,
                   Diagnostics& diagnostics);

}  // namespace fourpost
