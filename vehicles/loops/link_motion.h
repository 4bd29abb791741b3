#pragma once

#include <string>

#include <Eigen/Core>

namespace fourpost {

/// A link with mass, and its motion per unit of the independent coordinates.
struct LinkMotion {
  std::string name;
  double mass = 0;
  /// Principal moments as if the axes were principal: Ixx, Iyy, Izz.
  Eigen::Vector3d inertia;
  /// Centre of mass in ground axes, design pose [m].
  Eigen::Vector3d com;
  /// 3 x n: velocity of the centre of mass (ground axes) and angular velocity (link axes).
  Eigen::MatrixXd com_jacobian;
  Eigen::MatrixXd spin_jacobian;
};

}  // namespace fourpost
