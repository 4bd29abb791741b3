#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/poses/rest_solver.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// A load on one wheel of a rig; ground axes, which are those of the held chassis. A braked wheel is locked to the link
/// that carries its tyre, and so is the wheel of a rigid driven axle; the force of a driven wheel of which the body
/// takes the torque acts at its centre.
enum class WheelLoad { kLateral, kBraking, kDriving, kAligning };

/// A vehicle on a kinematics and compliance rig, in its full geometry: the chassis held as in the design pose, the
/// wheel centres led up and down by forces at the tyres' feet, on pads that float in the plane. Tyres are rigid, wheels
/// do not spin. All else is at rest under weights, springs, bushings and anti-roll bars.
class SuspensionRig {
 public:
  /// Throws FaultyInput if the vehicle cannot be assembled or held in its design pose.
  SuspensionRig(const Vehicle& vehicle, std::span<const double> parameters);
  /// With preloads that are known; those of tyres do not count.
  SuspensionRig(const Vehicle& vehicle, std::span<const double> parameters, Preloads preloads);

  struct Pose {
    RestSolver::Rest rest;
    /// One per wheel [m], of its centre from the design pose.
    Eigen::VectorXd rise;
  };

  const Vehicle& vehicle() const { return vehicle_; }
  const Suspension& suspension() const { return suspension_; }
  Pose Design();

  /// To other rises, on the straight way there; the last pose that is reached, within 0.01 mm, where the wheels cannot
  /// go on, as at a dead centre. Laws may have kinks on the way, such as where a stop is met.
  Pose Move(const Pose& from, const Eigen::VectorXd& rise);

  /// The geometry of a pose, in the joint coordinates.
  Kinematics At(const Pose& pose);
  /// Change of the joint coordinates as the wheels rise in this ratio; empty if they cannot move so.
  std::optional<Eigen::VectorXd> Tangent(const Pose& pose, const Eigen::VectorXd& rise);
  /// One per wheel: force of its pad [N], up.
  Eigen::VectorXd PadForces(const Pose& pose) const;

  /// Whether nothing yields: the wheels' places follow from the geometry alone.
  bool IsRigid(const Pose& pose);
  /// Change of the joint coordinates per N, or N m, of a load on each wheel, one factor each; pads keep their heights.
  /// Empty if nothing holds what the load moves.
  std::optional<Eigen::VectorXd> Yield(const Pose& pose, WheelLoad load, const Eigen::VectorXd& factors);

 private:
  Eigen::Index wheels() const { return static_cast<Eigen::Index>(suspension_.wheels.size()); }
  RestSolver::Guides GuidesAt(const Kinematics& pose, const Eigen::VectorXd& rise) const;
  /// The pose after a step along `tangent`, the change of the joint coordinates per `way`, which becomes the tangent
  /// there; empty if it is none, or if the path does not lead there.
  std::optional<Pose> Follow(const Pose& from, double step, const Eigen::VectorXd& way, const Eigen::VectorXd& rise,
                             Eigen::VectorXd& tangent);
  RestSolver::Guide GuideTo(const Eigen::VectorXd& rise) const;

  Vehicle vehicle_;
  Multibody multibody_;
  RestSolver solver_;
  Suspension suspension_;
  /// Link that stands for the chassis; -1: the ground is the chassis.
  int chassis_ = -1;
  Eigen::Isometry3d chassis_pose_;
  /// Heights of the wheel centres in the design pose.
  Eigen::VectorXd heights_;
  /// Tyres' links that spin on their parents, and the parents.
  struct Spin {
    int link = -1;
    int parent = -1;
  };
  std::vector<Spin> spins_;
};

}  // namespace fourpost
