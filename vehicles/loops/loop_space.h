#pragma once

#include <limits>

#include <Eigen/Core>

namespace fourpost {

/// A singular value of a loop Jacobian [m/m, m/rad, rad/rad] above this share of the largest, or of one where that is
/// less, is an equation. Metres and radians weigh alike, for a car's points lie about a metre from its joints: real
/// equations have 1e-3 to 10. Equations that repeat others leave the rounding of a closed pose, 1e-13; those that
/// repeat them in numbers typed with seven digits, 1e-7, do lock a car, as they do in the multibody system.
constexpr double kLoopRankTolerance = 1e-9;

/// What loop closures leave of the joint coordinates' rates in one pose.
struct LoopSpace {
  Eigen::Index rank = 0;
  /// Least singular value that counts; 1 where there is none.
  double least = 1;
  /// coordinates x (coordinates - rank), orthonormal: jacobian motions = 0.
  Eigen::MatrixXd motions;
  /// rows x (rows - rank), orthonormal: forces of the closures that balance each other, jacobian' stresses = 0.
  Eigen::MatrixXd stresses;
};

/// `most`: rank from another pose that is to be kept; smaller singular values are left out.
LoopSpace LoopSpaceOf(const Eigen::MatrixXd& jacobian, Eigen::Index most = std::numeric_limits<Eigen::Index>::max());

}  // namespace fourpost
