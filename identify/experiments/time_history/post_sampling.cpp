#include "identify/experiments/time_history/post_sampling.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "analysis/signals/noise_floor.h"
#include "analysis/signals/spectrum.h"

namespace fourpost {

std::optional<double> SampledTooSlowly(const Eigen::VectorXd& height, double rate_Hz,
                                       const std::optional<LowPassDesign>& filter) {
  constexpr double kMostOf = 0.95;
  if (height.size() < 16) return std::nullopt;
  const auto segment = static_cast<std::size_t>(std::min<Eigen::Index>(1024, height.size()));
  const std::span<const double> heights(height.data(), static_cast<std::size_t>(height.size()));
  const Spectrum spectrum = WelchSpectrum(heights, heights, rate_Hz, segment);
  // Noise of the sensor is no motion; a spectrum of few averages scatters by a factor of three.
  const double noise = 3 * 2 * std::pow(NoiseFloor(heights), 2) / rate_Hz;
  // Beyond it nothing of the posts is kept, see Unfiltered(): what is there is noise.
  const double taken_back_Hz = filter ? std::min(0.4 * rate_Hz, 2.5 * filter->cutoff_Hz) : rate_Hz;
  std::vector<double> below;
  double sum = 0;
  // Of velocity, which dampers and sweeps go by.
  for (std::size_t i = 0; i < spectrum.first.size() && spectrum.frequency_Hz[i] <= taken_back_Hz; ++i) {
    const double density = spectrum.first[i] > noise ? spectrum.first[i] : 0;
    below.push_back(sum += std::pow(spectrum.frequency_Hz[i], 2) * density);
  }
  const auto upper = std::lower_bound(below.begin(), below.end(), kMostOf * sum) - below.begin();
  const double upper_Hz = spectrum.frequency_Hz[static_cast<std::size_t>(upper)];
  if (sum == 0 || rate_Hz >= kLeastSamplesAPeriod * upper_Hz) return std::nullopt;
  return upper_Hz;
}

}  // namespace fourpost
