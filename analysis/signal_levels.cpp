#include "analysis/signal_levels.h"

#include <algorithm>
#include <vector>

namespace fourpost {
namespace {

/// Samples in a row at one extreme that a smooth signal does not have.
constexpr std::size_t kClippedRun = 4;

}  // namespace

double LevelOf(std::span<const double> signal) {
  std::vector<double> sorted(signal.begin(), signal.end());
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty()) return 0;
  const double span = sorted.back() - sorted.front();
  double least = span;
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (const double gap = sorted[k] - sorted[k - 1]; gap > 1e-9 * span) least = std::min(least, gap);
  return least;
}

std::size_t ClippedAtTop(std::span<const double> signal, double level) {
  if (signal.empty() || level == 0) return 0;
  const double top = *std::max_element(signal.begin(), signal.end());
  std::size_t clipped = 0;
  for (std::size_t k = 0; k < signal.size();) {
    std::size_t end = k;
    while (end < signal.size() && signal[end] == top) ++end;
    const bool steep =
        (k > 0 && top - signal[k - 1] > 1.5 * level) || (end < signal.size() && top - signal[end] > 1.5 * level);
    if (end - k >= kClippedRun && steep) clipped += end - k;
    k = end + 1;
  }
  return clipped;
}

std::size_t ClippedAtBottom(std::span<const double> signal, double level) {
  std::vector<double> mirrored(signal.size());
  std::transform(signal.begin(), signal.end(), mirrored.begin(), [](double value) { return -value; });
  return ClippedAtTop(mirrored, level);
}

}  // namespace fourpost
