#pragma once

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// Where a wheel stands; ground axes, angles by ISO 8855. With the wheel's axis a, the y axis of the link that carries
/// its tyre, o = a on the left and -a on the right:
///   camber = -asin(o_z),  steer = atan2(-a_x, a_y),  toe = -steer on the left, steer on the right.
struct WheelPlace {
  /// Positive with the top leaning outward [rad].
  double camber = 0;
  /// Positive to the left [rad].
  double steer = 0;
  /// Positive with the front toward the middle [rad].
  double toe = 0;
  /// Of the wheel's centre and of the tyre's foot [m].
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
};

/// `side`: +1 on the left, -1 on the right.
WheelPlace WheelPlaceOf(const Tyre& tyre, int side, const Kinematics& pose);

/// Change of all of them per unit of a motion of the coordinates of the pose.
WheelPlace WheelRateOf(const Tyre& tyre, int side, const Kinematics& pose, const Eigen::VectorXd& motion);

}  // namespace fourpost
