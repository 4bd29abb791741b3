#include "vehicles/poses/wheel_place.h"

#include <cmath>

namespace fourpost {

WheelPlace WheelPlaceOf(const Tyre& tyre, int side, const Kinematics& pose) {
  const Eigen::Vector3d axis = pose.Rotation(tyre.point.link).col(1);
  WheelPlace place;
  place.camber = -side * std::asin(axis.z());
  place.steer = std::atan2(-axis.x(), axis.y());
  place.toe = -side * place.steer;
  place.centre = pose.Location(tyre.point);
  for (Eigen::Index i = 0; i < 3; ++i) place.foot[i] = pose.FootPosition(tyre, Eigen::Vector3d::Unit(i)).value;
  return place;
}

WheelPlace WheelRateOf(const Tyre& tyre, int side, const Kinematics& pose, const Eigen::VectorXd& motion) {
  const Eigen::Vector3d axis = pose.Rotation(tyre.point.link).col(1);
  const Eigen::Vector3d spin = pose.AngularJacobian(tyre.point.link) * motion;
  const Eigen::Vector3d change = spin.cross(axis);
  WheelPlace rate;
  rate.camber = -side * change.z() / std::sqrt(1 - axis.z() * axis.z());
  rate.steer = (axis.x() * change.y() - axis.y() * change.x()) / (axis.x() * axis.x() + axis.y() * axis.y());
  rate.toe = -side * rate.steer;
  rate.centre = pose.PointJacobian(tyre.point) * motion;
  for (Eigen::Index i = 0; i < 3; ++i)
    rate.foot[i] = pose.FootPosition(tyre, Eigen::Vector3d::Unit(i)).gradient.dot(motion);
  return rate;
}

}  // namespace fourpost
