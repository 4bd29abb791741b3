#pragma once

#include <vector>

#include "analysis/frequency_response.h"
#include "identify/four_post_data.h"
#include "identify/lint/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A load cell that feels a wheelpan the vehicle does not have, or the other way round. `modelled` as ModelledResponses
/// of the runs.
void LintWheelpans(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                   const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings);

}  // namespace fourpost
