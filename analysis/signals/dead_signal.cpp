#include "analysis/signals/dead_signal.h"

#include <cmath>
#include <cstddef>

#include "analysis/signals/signal_levels.h"

namespace fourpost {

bool IsDead(std::span<const double> signal) {
  constexpr std::size_t kFewest = 64;
  constexpr double kMostLevels = 2;
  // Of a motion, which is sampled six times a period at least, more than half lasts.
  constexpr double kLasting = 0.3;
  if (signal.size() < kFewest) return false;
  double mean = 0;
  for (const double value : signal) mean += value / static_cast<double>(signal.size());
  double squares = 0;
  double products = 0;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    squares += (signal[k] - mean) * (signal[k] - mean);
    if (k > 0) products += (signal[k] - mean) * (signal[k - 1] - mean);
  }
  const double rms = std::sqrt(squares / static_cast<double>(signal.size()));
  return rms < kMostLevels * LevelOf(signal) && std::abs(products) < kLasting * squares;
}

}  // namespace fourpost
