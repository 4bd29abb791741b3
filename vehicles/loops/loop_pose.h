#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "vehicles/loops/loop_space.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Motions have unit length in radians and metres. A car's points follow them with 1e-3 or more, or not at all;
/// rounding and nearly redundant closures leave less than this.
constexpr double kStill = 1e-6;

/// Indices in Vehicle::links or Multibody::loop_closures.
using Indices = std::vector<std::size_t>;

/// Combinations of the columns in the null space of `rows`.
Eigen::MatrixXd Unseen(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& columns);

/// Motions in one pose, in joint coordinates.
class LoopPose {
 public:
  /// Uses the current pose of the multibody.
  explicit LoopPose(const Multibody& multibody);

  const Kinematics& kinematics() const { return kinematics_; }
  /// Jacobian of the loop errors.
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  const LoopSpace& space() const { return space_; }

  Eigen::Index coordinates() const { return jacobian_.cols(); }

  /// Motions that these closures alone allow.
  LoopSpace SpaceOf(const Indices& closures, Eigen::Index most_rank = std::numeric_limits<Eigen::Index>::max()) const;

  /// Whether no motion of these, in columns, moves two links against each other.
  bool MoveTogether(int a, int b, const Eigen::MatrixXd& motions) const;

  /// The part of the motions in which a link stands still.
  Eigen::MatrixXd Holding(int link, const Eigen::MatrixXd& motions) const;

 private:
  Kinematics kinematics_;
  std::vector<LoopClosure> closures_;
  Eigen::MatrixXd jacobian_;
  LoopSpace space_;
};

}  // namespace fourpost
