#pragma once

#include <Eigen/Core>

namespace fourpost {

/// The real factor that brings one response nearest to another, and the share of the other's squares that it explains.
struct RealFactor {
  double factor = 0;
  double explained = 0;
};

/// `factor * x` for `y`, of one size.
RealFactor RealFactorOf(const Eigen::VectorXcd& y, const Eigen::VectorXcd& x);

}  // namespace fourpost
