#pragma once

#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/study_file/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Load cells that feel wheelpans the vehicle does not have, or the other way round, each kind as one warning.
/// `modelled` as ModelledResponses of the runs.
void LintWheelpans(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings);

}  // namespace fourpost
