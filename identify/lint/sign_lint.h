#pragma once

#include <vector>

#include "analysis/frequency_response.h"
#include "identify/four_post_data.h"
#include "identify/lint/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A channel of another sign than the vehicle has. `modelled` as ModelledResponses of the runs.
void LintSigns(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
               const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings);

}  // namespace fourpost
