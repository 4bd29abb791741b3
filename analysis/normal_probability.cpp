#include "analysis/normal_probability.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/option_check.h"

namespace fourpost {
namespace {

double NormalDistribution(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// Filliben's.
double MedianOfOrder(std::size_t k, std::size_t count) {
  const auto n = static_cast<double>(count);
  const double last = std::pow(0.5, 1 / n);
  if (k == 0) return 1 - last;
  if (k + 1 == count) return last;
  return (static_cast<double>(k) + 1 - 0.3175) / (n + 0.365);
}

}  // namespace

// Halley's method on the lower half, where the distribution's relative error is that of erfc.
double NormalQuantile(double probability) {
  RequireOption(probability > 0 && probability < 1, "NormalQuantile: probability", probability, "above 0 and below 1");
  if (probability > 0.5) return -NormalQuantile(1 - probability);
  const double tail = std::sqrt(-2 * std::log(probability));
  // Hastings; errs by 4.5e-4.
  double x = -(tail - (2.515517 + tail * (0.802853 + tail * 0.010328)) /
                          (1 + tail * (1.432788 + tail * (0.189269 + tail * 0.001308))));
  for (int i = 0; i < 3; ++i) {
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
    const double step = (NormalDistribution(x) - probability) / density;
    x -= step / (1 + 0.5 * x * step);
  }
  return x;
}

NormalProbability NormalProbabilityOf(std::vector<double> samples) {
  RequireOption(samples.size() >= 3, "NormalProbabilityOf: samples", samples.size(), "three at least");
  std::sort(samples.begin(), samples.end());
  NormalProbability out{.ordered = std::move(samples)};
  const std::size_t count = out.ordered.size();
  double mean = 0;
  for (std::size_t k = 0; k < count; ++k) {
    out.quantile.push_back(NormalQuantile(MedianOfOrder(k, count)));
    mean += out.ordered[k] / static_cast<double>(count);
  }
  // Quantiles are symmetric about 0.
  double moment = 0;
  double square = 0;
  double spread = 0;
  for (std::size_t k = 0; k < count; ++k) {
    moment += out.quantile[k] * (out.ordered[k] - mean);
    square += out.quantile[k] * out.quantile[k];
    spread += (out.ordered[k] - mean) * (out.ordered[k] - mean);
  }
  out.slope = moment / square;
  out.intercept = mean;
  out.correlation = moment / std::sqrt(square * spread);
  return out;
}

}  // namespace fourpost
