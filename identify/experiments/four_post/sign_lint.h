#pragma once

#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/study_file/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A channel of another sign than the vehicle has. `modelled` as ModelledResponses of the runs.
void LintSigns(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
               const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings);

}  // namespace fourpost
