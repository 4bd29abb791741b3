#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fourpost {

/// Cross(a) b = a x b.
inline Eigen::Matrix3d Cross(const Eigen::Vector3d& v) {
  Eigen::Matrix3d cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return cross;
}

/// A small turn as twice the vector part of its quaternion (eta, eps), and its rate for an angular velocity w:
///   value = 2 eps,   value' = rate w = (eta - eps x) w.
/// From q' = (0, w) q / 2. Differs from the turn's angle by a 24th of its cube.
struct SmallTurn {
  Eigen::Vector3d value;
  Eigen::Matrix3d rate;

  /// `turn`: from the turned axes to the axes in which w is given.
  explicit SmallTurn(const Eigen::Matrix3d& turn) {
    Eigen::Quaterniond q(turn);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    value = 2 * q.vec();
    rate = q.w() * Eigen::Matrix3d::Identity() - Cross(q.vec());
  }
};

}  // namespace fourpost
