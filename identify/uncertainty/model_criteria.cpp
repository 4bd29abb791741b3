#include "identify/uncertainty/model_criteria.h"

#include <cmath>
#include <limits>

namespace fourpost {

ModelCriteria CriteriaOf(double squares, std::size_t residuals, std::size_t parameters) {
  const auto n = static_cast<double>(residuals);
  const auto p = static_cast<double>(parameters + 1);
  const double fit = n * std::log(squares / n);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool enough = n > p + 1;
  return {.residuals = residuals,
          .parameters = parameters,
          .aicc = enough ? fit + 2 * p + 2 * p * (p + 1) / (n - p - 1) : nan,
          .bic = enough ? fit + p * std::log(n) : nan};
}

}  // namespace fourpost
