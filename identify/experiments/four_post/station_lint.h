#pragma once

#include <vector>

#include "identify/experiments/four_post/four_post_data.h"
#include "identify/study_file/channel_warnings.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// An accelerometer that does not move with its body below 1 Hz, where that is rigid: its station is wrong by far, or
/// its sign, or its scale.
void LintStations(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs, ChannelWarnings& warnings);

}  // namespace fourpost
