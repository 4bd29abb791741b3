#include "analysis/signals/deviation.h"

#include <cmath>
#include <numeric>

namespace fourpost {

double Mean(std::span<const double> signal) {
  return std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
}

double DeviationOf(std::span<const double> signal) {
  if (signal.empty()) return 0;
  const double mean = Mean(signal);
  double square = 0;
  for (const double sample : signal) square += (sample - mean) * (sample - mean);
  return std::sqrt(square / static_cast<double>(signal.size()));
}

}  // namespace fourpost
