#include "analysis/signals/dead_signal.h"

#include <cmath>
#include <cstddef>

#include "analysis/signals/deviation.h"
#include "analysis/signals/signal_levels.h"

namespace fourpost {

bool IsDead(std::span<const double> signal) {
  constexpr std::size_t kFewest = 64;
  constexpr double kMostLevels = 2;
  // Of a motion, which is sampled six times a period at least, more than half lasts.
  constexpr double kLasting = 0.3;
  if (signal.size() < kFewest) return false;
  const double mean = Mean(signal);
  const double deviation = DeviationOf(signal);
  double products = 0;
  for (std::size_t k = 1; k < signal.size(); ++k) products += (signal[k] - mean) * (signal[k - 1] - mean);
  const double squares = deviation * deviation * static_cast<double>(signal.size());
  // Levels last: they take a search.
  return std::abs(products) < kLasting * squares && deviation < kMostLevels * LevelOf(signal);
}

}  // namespace fourpost
