#pragma once

#include <span>
#include <vector>

#include "analysis/files/time_recording.h"
#include "identify/experiments/time_history/measured_history.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Of gaps in an input, the height of a post or a tension, those that interpolation bridges with an error that shows:
/// its rms over as many samples at a hundred places near the gap, from which they are left out for it, is above
/// `unseen`. Gaps at an end of the recording, where nothing can be interpolated, always show. `input`: samples of the
/// recording, the gaps bridged.
std::vector<BridgedGap> VisibleGaps(const TimeRecording& recording, std::span<const double> input, double unseen,
                                    const std::vector<BridgedGap>& gaps);

/// Where the motion of a vehicle is not known.
struct UnknownMotion {
  /// In order, those that overlap as one; of those behind which the window has a sample that is left out.
  std::vector<BridgedGap> gaps;
  /// How long the vehicle settles behind each [s]: its slowest mode to a hundredth, ten seconds at most.
  double settled_s = 0;
  /// Of the window, left out.
  Eigen::Index samples = 0;
};

/// Takes the weight from all signals in these gaps and until the vehicle of the file has settled behind each.
UnknownMotion LeaveOutMotion(const Vehicle& vehicle, std::vector<BridgedGap> gaps, MeasuredHistory& history);

}  // namespace fourpost
