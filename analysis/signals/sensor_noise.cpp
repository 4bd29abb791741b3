#include "analysis/signals/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "analysis/signals/autocorrelation.h"
#include "analysis/signals/drift.h"
#include "analysis/signals/median.h"
#include "analysis/signals/spectrum.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

constexpr std::size_t kFewest = 64;

void AddMoments(const Eigen::VectorXd& signal, SensorNoise& noise) {
  const auto n = static_cast<double>(signal.size());
  noise.sd = std::sqrt(signal.squaredNorm() / n);
  if (!(noise.sd > 0)) return;
  const Eigen::ArrayXd scaled = signal.array() / noise.sd;
  noise.skewness = scaled.cube().sum() / n;
  noise.kurtosis = scaled.square().square().sum() / n - 3;
  constexpr double kDeviations = 4;
  constexpr double kSmallSkewness = 0.3;
  constexpr double kSmallKurtosis = 0.5;
  const double samples = EffectiveSamples(signal);
  noise.is_normal = std::abs(noise.skewness) < std::max(kSmallSkewness, kDeviations * std::sqrt(6 / samples)) &&
                    std::abs(noise.kurtosis) < std::max(kSmallKurtosis, kDeviations * std::sqrt(24 / samples));
}

void AddSpectrum(const std::vector<double>& signal, double rate_Hz, SensorNoise& noise) {
  constexpr std::size_t kLongest = 1024;
  constexpr double kMost = 0.95;
  constexpr double kAbove = 20;
  constexpr double kShare = 0.1;
  const std::size_t segment = std::min(kLongest, signal.size() / 2);
  const Spectrum spectrum = WelchSpectrum(signal, signal, rate_Hz, segment);
  const std::vector<double>& power = spectrum.first;
  double sum = 0;
  // The mean of each segment is gone.
  for (std::size_t i = 1; i < power.size(); ++i) sum += power[i];
  double below = 0;
  for (std::size_t i = 1; i < power.size() && below < kMost * sum; ++i) {
    below += power[i];
    noise.below_Hz = spectrum.frequency_Hz[i];
  }
  const auto peak = static_cast<std::size_t>(std::max_element(power.begin() + 1, power.end()) - power.begin());
  // Hann's window spreads a line over three bins. Below the fourth it is drift.
  constexpr std::size_t kFirst = 4;
  if (peak < kFirst || peak + 1 >= power.size()) return;
  const double line = power[peak - 1] + power[peak] + power[peak + 1];
  if (power[peak] > kAbove * Median(power) && line > kShare * sum) noise.line_Hz = spectrum.frequency_Hz[peak];
}

}  // namespace

SensorNoise SensorNoiseOf(std::span<const double> at_rest, double rate_Hz) {
  RequireOption(at_rest.size() >= kFewest, "SensorNoiseOf: samples", at_rest.size(), "64 at least");
  std::vector<double> signal(at_rest.begin(), at_rest.end());
  RemoveTrend(signal);
  const Eigen::Map<const Eigen::VectorXd> values(signal.data(), static_cast<Eigen::Index>(signal.size()));
  SensorNoise noise;
  AddMoments(values, noise);
  if (!(noise.sd > 0)) return noise;
  noise.is_white = WhitenessOf(values).IsWhite();
  AddSpectrum(signal, rate_Hz, noise);
  return noise;
}

}  // namespace fourpost
