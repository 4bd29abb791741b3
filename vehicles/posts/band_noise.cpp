#include "vehicles/posts/band_noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace fourpost {

SineGrid SineGrid::For(double upper_Hz, double duration_s) {
  constexpr double kPerPeriod = 64;
  const double step = 1 / (kPerPeriod * upper_Hz);
  return {step, std::bit_ceil(static_cast<std::size_t>(std::ceil(duration_s / step)) + 1)};
}

std::vector<double> SumOfSines(const SineGrid& grid, double lower_Hz, double upper_Hz,
                               const std::function<std::complex<double>(double frequency_Hz)>& phasor) {
  std::vector<std::complex<double>> spectrum(grid.count);
  const double spacing = grid.spacing_Hz();
  for (auto k = static_cast<std::size_t>(std::ceil(lower_Hz / spacing)); k < grid.count / 2; ++k) {
    const double frequency = static_cast<double>(k) * spacing;
    if (frequency > upper_Hz) break;
    spectrum[k] = phasor(frequency);
  }
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::Unscaled);
  std::vector<std::complex<double>> sum;
  transform.inv(sum, spectrum);
  std::vector<double> samples(grid.count);
  std::transform(sum.begin(), sum.end(), samples.begin(),
                 [](const std::complex<double>& value) { return value.real(); });
  return samples;
}

std::vector<double> Faded(std::vector<double> samples, double step_s, double duration_s) {
  samples.resize(std::min(samples.size(), static_cast<std::size_t>(std::ceil(duration_s / step_s)) + 1));
  const std::size_t fade = std::min(samples.size() / 4, static_cast<std::size_t>(1 / step_s));
  for (std::size_t k = 0; k < fade; ++k) {
    const double share = 0.5 * (1 - std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(fade)));
    samples[k] *= share;
    samples[samples.size() - 1 - k] *= share;
  }
  return samples;
}

}  // namespace fourpost
