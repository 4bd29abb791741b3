#pragma once

#include <cmath>

#include <Eigen/Core>

#include "vehicles/multibody/small_turn.h"

namespace fourpost {

/// Point of a tyre on its platform: `radius` from the wheel's centre, in the plane normal to the wheel's axis a (the y
/// axis of its link), as low as that plane allows. With u = (z - (z . a) a) / s, s = |z - (z . a) a|, z up:
///   offset = -radius u,   offset' = rate w,  w the link's angular velocity;   all in ground axes.
/// Turning the link about a does not move the foot.
struct TyreFoot {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();

  TyreFoot(const Eigen::Matrix3d& rotation, double radius) {
    if (radius == 0) return;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d axis = rotation.col(1);
    const double s = std::sqrt(1 - axis.z() * axis.z());
    const Eigen::Vector3d u = (up - axis.z() * axis) / s;
    // du/da, with a' = w x a.
    const Eigen::Matrix3d by_axis =
        -(axis * up.transpose() + axis.z() * Eigen::Matrix3d::Identity()) / s + axis.z() / (s * s) * u * up.transpose();
    offset = -radius * u;
    rate = radius * by_axis * Cross(axis);
  }
};

}  // namespace fourpost
