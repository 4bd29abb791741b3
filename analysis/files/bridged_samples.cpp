#include "analysis/files/bridged_samples.h"

#include <algorithm>

namespace fourpost {

std::vector<char> BridgedSamples(const TimeRecording& recording, const std::vector<BridgedGap>& gaps) {
  const double rounding = 1e-6 * recording.step_s;
  std::vector<char> is_bridged(gaps.empty() ? 0 : recording.samples());
  for (std::size_t k = 0; k < is_bridged.size(); ++k)
    is_bridged[k] = std::any_of(gaps.begin(), gaps.end(), [&, t = recording.time_s(k)](const BridgedGap& gap) {
      return t > gap.from_s + rounding && t < gap.to_s - rounding;
    });
  return is_bridged;
}

}  // namespace fourpost
