#pragma once

#include <span>
#include <vector>

#include "analysis/files/time_recording.h"

namespace fourpost {

/// Interpolates what is not a number, see InterpolatedAt(), which throws.
void BridgeMissing(std::span<const double> times, std::vector<double>& signal);

/// In order, those that overlap as one.
std::vector<BridgedGap> MergedGaps(std::vector<BridgedGap> gaps);

/// Per sample of a recording, whether it lies in one of the gaps. Empty without gaps.
std::vector<char> BridgedSamples(const TimeRecording& recording, const std::vector<BridgedGap>& gaps);

}  // namespace fourpost
