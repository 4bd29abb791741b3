#include "analysis/signals/spectrum.h"

#include <cmath>
#include <numbers>

#include <unsupported/Eigen/FFT>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

std::vector<double> HannWindow(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t k = 0; k < size; ++k)
    window[k] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size));
  return window;
}

/// Spectrum of a segment without its mean.
std::vector<std::complex<double>> Transform(std::span<const double> segment, const std::vector<double>& window) {
  double mean = 0;
  for (const double sample : segment) mean += sample / static_cast<double>(segment.size());
  std::vector<double> windowed;
  for (std::size_t k = 0; k < segment.size(); ++k) windowed.push_back(window[k] * (segment[k] - mean));
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.fwd(spectrum, windowed);
  return spectrum;
}

}  // namespace

std::vector<double> Spectrum::Coherence() const {
  std::vector<double> coherence;
  for (std::size_t k = 0; k < cross.size(); ++k) coherence.push_back(std::norm(cross[k]) / (first[k] * second[k]));
  return coherence;
}

Spectrum WelchSpectrum(std::span<const double> first, std::span<const double> second, double rate_Hz,
                       std::size_t segment) {
  RequireOption(first.size() == second.size(), "WelchSpectrum: samples of the second signal", second.size(),
                "as many as of the first");
  RequireOption(segment >= 4 && segment <= first.size(), "WelchSpectrum: segment", segment,
                "4 at least and no longer than the signals");
  RequireOption(rate_Hz > 0 && std::isfinite(rate_Hz), "WelchSpectrum: rate_Hz", rate_Hz, "positive and finite");
  const std::vector<double> window = HannWindow(segment);
  double power = 0;
  for (const double weight : window) power += weight * weight;
  const std::size_t bins = segment / 2 + 1;
  Spectrum out{.frequency_Hz = std::vector<double>(bins),
               .first = std::vector<double>(bins),
               .second = std::vector<double>(bins),
               .cross = std::vector<std::complex<double>>(bins)};
  const std::size_t step = segment - segment / 2;
  const std::size_t count = (first.size() - segment) / step + 1;
  for (std::size_t s = 0; s < count; ++s) {
    const auto one = Transform(first.subspan(s * step, segment), window);
    const auto other = Transform(second.subspan(s * step, segment), window);
    for (std::size_t k = 0; k < bins; ++k) {
      // Negative frequencies counted in, but for zero and half the rate, which have none.
      const bool is_alone = k == 0 || (segment % 2 == 0 && k == bins - 1);
      const double scale = (is_alone ? 1 : 2) / (rate_Hz * power * static_cast<double>(count));
      out.first[k] += scale * std::norm(one[k]);
      out.second[k] += scale * std::norm(other[k]);
      out.cross[k] += scale * std::conj(one[k]) * other[k];
    }
  }
  for (std::size_t k = 0; k < bins; ++k)
    out.frequency_Hz[k] = rate_Hz * static_cast<double>(k) / static_cast<double>(segment);
  return out;
}

}  // namespace fourpost
