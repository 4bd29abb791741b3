#include "identify/experiments/four_post/real_factor.h"

#include <algorithm>
#include <limits>

namespace fourpost {

RealFactor RealFactorOf(const Eigen::VectorXcd& y, const Eigen::VectorXcd& x) {
  const double factor = x.dot(y).real() / std::max(x.squaredNorm(), std::numeric_limits<double>::min());
  return {factor, 1 - (y - factor * x).squaredNorm() / y.squaredNorm()};
}

}  // namespace fourpost
