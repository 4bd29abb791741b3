#include "analysis/signals/signal_levels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace fourpost {
namespace {

/// Samples in a row at one extreme that a smooth signal does not have.
constexpr std::size_t kClippedRun = 4;

/// Without repetitions where values are few, as of converters: sorting an hour of a channel takes ten times as long.
/// All values where they are many.
std::vector<double> Distinct(std::span<const double> signal) {
  constexpr int kBits = 18;
  constexpr std::size_t kSlots = std::size_t{1} << kBits;
  if (signal.size() < kSlots) return {signal.begin(), signal.end()};
  std::vector<double> slots(kSlots, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> distinct;
  for (const double value : signal) {
    // Fibonacci hashing (Knuth, The Art of Computer Programming, volume 3, section 6.4).
    std::size_t slot = (std::bit_cast<std::uint64_t>(value) * 0x9E3779B97F4A7C15) >> (64 - kBits);
    while (!std::isnan(slots[slot]) && slots[slot] != value) slot = (slot + 1) % kSlots;
    if (slots[slot] == value) continue;
    if (distinct.size() == kSlots / 2) return {signal.begin(), signal.end()};
    slots[slot] = value;
    distinct.push_back(value);
  }
  return distinct;
}

}  // namespace

double LevelOf(std::span<const double> signal) {
  std::vector<double> sorted = Distinct(signal);
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
    const auto rises = [&](std::size_t reach, double by) { return k >= reach && top - signal[k - reach] > by; };
    const auto falls = [&](std::size_t reach, double by) {
      return end + reach <= signal.size() && top - signal[end + reach - 1] > by;
    };
    // What just reaches the top before it is clipped leaves it by little: a crest of sixteen samples and more falls by
    // two levels within an eighth of them.
    const std::size_t eighth = (end - k) / 8;
    const bool steep = rises(1, 1.5 * level) || falls(1, 1.5 * level) ||
                       (eighth > 1 && rises(eighth, 2.5 * level) && falls(eighth, 2.5 * level));
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
