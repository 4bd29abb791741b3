#pragma once

#include <vector>

namespace fourpost {

/// Value below which a standard normal variable lies with this probability, to rounding. Throws std::invalid_argument
/// unless it is above 0 and below 1.
double NormalQuantile(double probability);

/// A normal-probability plot: samples of a normal distribution lie along a straight line over these quantiles.
struct NormalProbability {
  /// Rising, at Filliben's medians of the order statistics (Technometrics 17, 1975).
  std::vector<double> quantile;
  std::vector<double> ordered;
  /// Least-squares line: about the deviation and the mean of normal samples; and the correlation, near 1 for them.
  double slope = 0;
  double intercept = 0;
  double correlation = 0;
};

/// As scipy.stats.probplot. Throws std::invalid_argument for fewer than three samples.
NormalProbability NormalProbabilityOf(std::vector<double> samples);

}  // namespace fourpost
