#include "analysis/signals/noise_floor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "analysis/signals/spectrum.h"

namespace fourpost {

double NoiseFloor(std::span<const double> signal) {
  constexpr std::size_t kLeast = 64;
  constexpr double kFlat = 2;
  if (signal.size() < kLeast) return 0;
  // Of half the rate 1: the spectrum's mean is then the variance.
  const Spectrum spectrum = WelchSpectrum(signal, signal, 2, std::clamp<std::size_t>(signal.size() / 8, kLeast, 512));
  const std::vector<double>& power = spectrum.first;
  const std::size_t quarter = power.size() / 4;
  const auto mean = [&](std::size_t first, std::size_t count) {
    const auto begin = power.begin() + static_cast<std::ptrdiff_t>(first);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
  };
  const auto is_flat = [&](std::size_t first, std::size_t count) {
    const double lower = mean(first, count / 2);
    const double upper = mean(first + count / 2, count / 2);
    return lower < kFlat * upper && upper < kFlat * lower;
  };
  std::size_t lowest = 1;
  for (std::size_t first = 1; first + quarter < power.size(); ++first)
    if (mean(first, quarter) < mean(lowest, quarter)) lowest = first;
  // The lowest of many is a little too low: the upper half, which is not chosen for it, goes first.
  const std::size_t half = power.size() / 2;
  if (is_flat(half, half - 1) && mean(half, half - 1) < kFlat * mean(lowest, quarter))
    return std::sqrt(mean(half, half - 1));
  return is_flat(lowest, quarter) ? std::sqrt(mean(lowest, quarter)) : 0;
}

}  // namespace fourpost
