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
  const Spectrum spectrum =
      WelchSpectrum(signal, signal, 2, std::clamp<std::size_t>(signal.size() / 8, kLeast, 512));
  const std::vector<double>& power = spectrum.first;
  const std::size_t quarter = power.size() / 4;
  const auto mean = [&](std::size_t first, std::size_t count) {
    const auto begin = power.begin() + static_cast<std::ptrdiff_t>(first);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
  };
  std::size_t lowest = 1;
  for (std::size_t first = 1; first + quarter < power.size(); ++first)
    if (mean(first, quarter) < mean(lowest, quarter)) lowest = first;
  const double lower = mean(lowest, quarter / 2);
  const double upper = mean(lowest + quarter / 2, quarter / 2);
  if (!(lower < kFlat * upper && upper < kFlat * lower)) return 0;
  return std::sqrt(mean(lowest, quarter));
}

}  // namespace fourpost
