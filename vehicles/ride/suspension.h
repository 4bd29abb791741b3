#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/ride/body_motion.h"

namespace fourpost {

/// A tyre and its carrier, design pose, ground axes.
struct Wheel {
  /// The tyre's.
  std::string name;
  /// Link that carries the tyre.
  int link = -1;
  /// The link that the wheel is locked to when it does not spin: `link`, or its parent by the joint SpinOf.
  int carrier = -1;
  Eigen::Vector3d foot;
  /// n; rise of the foot.
  Eigen::VectorXd foot_rise;
  /// 6 x n; velocity of the tyre's centre, angular velocity of its link.
  Eigen::MatrixXd jacobian;
  /// +1 on the left of its axle, -1 on the right, 0 if the axle has one side only.
  int side = 0;
};

/// Wheels that stand beside each other.
struct Axle {
  /// "front", "axle 2", "rear"; "wheel" if there is one axle only.
  std::string name;
  /// Indices in Suspension::wheels.
  std::vector<std::size_t> wheels;

  bool HasTwoSides(std::span<const Wheel> all) const {
    return std::any_of(wheels.begin(), wheels.end(), [&](std::size_t i) { return all[i].side != 0; });
  }
};

/// A vehicle as a chassis engineer sees it.
struct Suspension {
  std::vector<BodyMotion> bodies;
  /// Index in bodies, see ChassisOf.
  int chassis = -1;
  /// In the order of Vehicle::tyres.
  std::vector<Wheel> wheels;
  /// From front to rear.
  std::vector<Axle> axles;
};

/// The joint about whose axis, through the tyre's centre, a wheel spins on its carrier; nullptr if there is none.
const Joint* SpinOf(const Vehicle& vehicle, const Tyre& tyre);

/// `pose`: the design pose.
Suspension SuspensionOf(const Vehicle& vehicle, const Kinematics& pose, std::span<const double> parameters);

}  // namespace fourpost
