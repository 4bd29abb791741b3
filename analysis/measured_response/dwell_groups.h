#pragma once

#include <span>
#include <vector>

#include "analysis/frequency_response/stepped_sine.h"

namespace fourpost {

/// Dwells of one pattern, and of one amplitude at each frequency: by frequency, dwells of one frequency together.
struct DwellGroup {
  PostShares shares;
  std::vector<std::vector<DwellResponse>> frequencies;
};

/// Dwells of the same shares are of one pattern; of the same frequency where a dwell cannot tell two apart, a third of
/// a cycle over it; repeats where amplitudes agree within 10 %. The next amplitude at a frequency goes to the next
/// group.
std::vector<DwellGroup> GroupsOf(std::span<const DwellResponse> dwells);

/// The mean over repeats. Variances are those of the mean: what the cycles within the dwells say, or the scatter of the
/// repeats, whichever is larger.
DwellResponse MeanOf(std::span<const DwellResponse> repeats);

}  // namespace fourpost
