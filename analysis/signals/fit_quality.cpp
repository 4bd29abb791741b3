#include "analysis/signals/fit_quality.h"

#include <cstddef>

#include "analysis/signals/deviation.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Of the error and of the measured signal about its mean.
struct Squares {
  double error = 0;
  double error_variance = 0;
  double variance = 0;
};

Squares MeanSquares(std::span<const double> measured, std::span<const double> modelled) {
  RequireOption(!measured.empty(), "samples", measured.size(), "one at least");
  RequireOption(measured.size() == modelled.size(), "modelled samples", modelled.size(), "as many as measured");
  const double mean = Mean(measured);
  const double mean_error = mean - Mean(modelled);
  Squares sum;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const double error = measured[k] - modelled[k];
    sum.error += error * error;
    sum.error_variance += (error - mean_error) * (error - mean_error);
    sum.variance += (measured[k] - mean) * (measured[k] - mean);
  }
  return sum;
}

}  // namespace

double NormalisedMse_percent(std::span<const double> measured, std::span<const double> modelled) {
  const Squares squares = MeanSquares(measured, modelled);
  return 100 * squares.error / squares.variance;
}

double VarianceAccountedFor_percent(std::span<const double> measured, std::span<const double> modelled) {
  const Squares squares = MeanSquares(measured, modelled);
  return 100 * (1 - squares.error_variance / squares.variance);
}

}  // namespace fourpost
