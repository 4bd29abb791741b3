#pragma once

#include <limits>

#include <Eigen/Core>

namespace fourpost {

/// A singular value of a loop Jacobian [m/m, m/rad, rad/rad] counts as an equation if it is above this share of the
/// largest, or of one where that is less. Metres and radians count alike, because a car's points lie about a metre from
/// its joints: real equations have 1e-3 to 10. Redundant equations leave the rounding of a closed pose, 1e-13.
/// Equations that are redundant except for numbers typed with seven digits, 1e-7, do lock a car, as in the multibody
/// system.
constexpr double kLoopRankTolerance = 1e-9;

/// Motions that loop closures allow in one pose, as rates of the joint coordinates.
struct LoopSpace {
  Eigen::Index rank = 0;
  /// Least singular value that counts; 1 if there is none.
  double least = 1;
  /// coordinates x (coordinates - rank), orthonormal: jacobian motions = 0.
  Eigen::MatrixXd motions;
  /// rows x (rows - rank), orthonormal: forces of the closures that balance each other, jacobian' stresses = 0.
  Eigen::MatrixXd stresses;
};

/// `most`: rank of another pose that is to be kept; smaller singular values are left out.
LoopSpace LoopSpaceOf(const Eigen::MatrixXd& jacobian, Eigen::Index most = std::numeric_limits<Eigen::Index>::max());

}  // namespace fourpost
