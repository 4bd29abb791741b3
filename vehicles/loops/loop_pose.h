#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "vehicles/loops/loop_space.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {

/// Motions are of unit length in radians and metres; a car's points follow them with 1e-3 or more, or not at all, and
/// what rounding and nearly redundant closures leave is below this.
constexpr double kStill = 1e-6;

/// Positions in Vehicle::links or Multibody::loop_closures.
using Indices = std::vector<std::size_t>;

/// The columns' combinations that `rows` do not see.
Eigen::MatrixXd Unseen(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& columns);

/// What moves how in one pose, in joint coordinates.
class LoopPose {
 public:
  /// Takes the pose of the multibody.
  explicit LoopPose(const Multibody& multibody);

  const Kinematics& kinematics() const { return kinematics_; }
  /// Of the loop errors.
  const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  const LoopSpace& space() const { return space_; }

  Eigen::Index coordinates() const { return jacobian_.cols(); }

  /// What these closures alone leave.
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
