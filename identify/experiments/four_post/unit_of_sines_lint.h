#pragma once

#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Amplitudes of posts that no rig makes, and channels that are a thousand times what the vehicle gives. Reported with
/// `severity`, amplitudes first; whether the unit of all recordings is likely. `modelled`: one per run.
bool LintAmplitudes(const FourPostPlan& plan, const std::vector<MeasuredRun>& runs, Severity severity,
                    Diagnostics& diagnostics);
void LintSineUnits(const FourPostPlan& plan, const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, Severity severity, Diagnostics& diagnostics);

}  // namespace fourpost
