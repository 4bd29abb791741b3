#pragma once

#include <Eigen/Core>

namespace fourpost {

/// A scalar of the geometry (a length, a height) in the design pose, with its derivatives by the independent
/// coordinates.
struct DesignShape {
  double value = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd curvature;
};

}  // namespace fourpost
