#pragma once

#include <vector>

#include "analysis/files/time_recording.h"

namespace fourpost {

/// Per sample of a recording, whether it lies in one of the gaps. Empty without gaps.
std::vector<char> BridgedSamples(const TimeRecording& recording, const std::vector<BridgedGap>& gaps);

}  // namespace fourpost
