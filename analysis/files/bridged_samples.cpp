#include "analysis/files/bridged_samples.h"

#include <algorithm>
#include <cmath>

#include "analysis/signals/uneven_samples.h"

namespace fourpost {

void BridgeMissing(std::span<const double> times, std::vector<double>& signal) {
  std::vector<double> at;
  std::vector<double> known;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    if (std::isnan(signal[k])) continue;
    at.push_back(times[k]);
    known.push_back(signal[k]);
  }
  const std::vector<double> bridged = InterpolatedAt(at, known, times);
  for (std::size_t k = 0; k < signal.size(); ++k)
    if (std::isnan(signal[k])) signal[k] = bridged[k];
}

std::vector<BridgedGap> MergedGaps(std::vector<BridgedGap> gaps) {
  std::sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) { return a.from_s < b.from_s; });
  std::vector<BridgedGap> merged;
  for (const BridgedGap& gap : gaps)
    if (!merged.empty() && gap.from_s <= merged.back().to_s)
      merged.back().to_s = std::max(merged.back().to_s, gap.to_s);
    else merged.push_back(gap);
  return merged;
}

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
