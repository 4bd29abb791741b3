#pragma once

#include <span>
#include <vector>

#include "analysis/files/time_recording.h"
#include "identify/experiments/time_history/measured_history.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Of gaps in an input, the height of a post or a tension, those that interpolation bridges with an error that shows:
/// its rms over as many samples elsewhere in the record, from which they are left out for it, is above three standard
/// deviations of the input's noise and a hundredth of its own rms. `input`: samples of the recording, the gaps bridged.
std::vector<BridgedGap> VisibleGaps(const TimeRecording& recording, std::span<const double> input, double noise_sd,
                                    const std::vector<BridgedGap>& gaps);

/// Takes the weight from all signals in these gaps and until the vehicle of the file has settled behind each: how it
/// moved there is not known. Returns how long it settles [s]: that of its slowest mode to a hundredth, ten seconds at
/// most.
double LeaveOutMotion(const Vehicle& vehicle, const std::vector<BridgedGap>& gaps, MeasuredHistory& history);

}  // namespace fourpost
