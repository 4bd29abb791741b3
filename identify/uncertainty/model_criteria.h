#pragma once

#include <cstddef>

namespace fourpost {

/// What a model's misfit is worth with the parameters that it took: the smaller the better, between models of the same
/// data only.
struct ModelCriteria {
  std::size_t residuals = 0;
  std::size_t parameters = 0;
  /// Akaike's criterion for few samples: n ln(S/n) + 2 p + 2 p (p + 1) / (n - p - 1), p = parameters + 1 with the
  /// variance; and the Bayesian one, n ln(S/n) + p ln n. S: sum of n squared residuals.
  double aicc = 0;
  double bic = 0;
};

/// NaN where there are too few residuals.
ModelCriteria CriteriaOf(double squares, std::size_t residuals, std::size_t parameters);

}  // namespace fourpost
