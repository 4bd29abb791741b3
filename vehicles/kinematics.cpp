#include "vehicles/kinematics.h"

#include "vehicles/small_turn.h"
#include "vehicles/tyre_foot.h"

namespace fourpost {
Kinematics::Kinematics(const Multibody& multibody, const Eigen::MatrixXd& tangent) {
  const int links = static_cast<int>(multibody.vehicle().links.size());
  for (int link = 0; link < links; ++link) {
    pose_.push_back(multibody.LinkPose(link));
    jacobian_.push_back(multibody.LinkJacobian(link) * tangent);
  }
}

Eigen::Vector3d Kinematics::Location(const Point& point) const {
  return pose_[static_cast<std::size_t>(point.link)] * point.xyz;
}

Eigen::Matrix3d Kinematics::Rotation(int link) const { return pose_[static_cast<std::size_t>(link)].linear(); }

Eigen::MatrixXd Kinematics::AngularJacobian(int link) const {
  return jacobian_[static_cast<std::size_t>(link)].topRows<3>();
}

Eigen::MatrixXd Kinematics::JacobianAt(int link, const Eigen::Vector3d& place) const {
  const Eigen::Vector3d arm = place - pose_[static_cast<std::size_t>(link)].translation();
  return jacobian_[static_cast<std::size_t>(link)].bottomRows<3>() - Cross(arm) * AngularJacobian(link);
}

Eigen::MatrixXd Kinematics::PointJacobian(const Point& point) const { return JacobianAt(point.link, Location(point)); }

Coordinate Kinematics::Position(const Point& point, const Eigen::Vector3d& direction) const {
  return {direction.dot(Location(point)), PointJacobian(point).transpose() * direction};
}

Coordinate Kinematics::LineLength(const ForceLine& line) const {
  const Eigen::Vector3d span = Location(line.parent) - Location(line.child);
  const Eigen::MatrixXd span_rate = PointJacobian(line.parent) - PointJacobian(line.child);
  if (!line.axis) {
    const double length = span.norm();
    return {length, span_rate.transpose() * (span / length)};
  }
  // The axis turns with the parent: d(axis . span) = axis . d(span) + (omega x axis) . span.
  const Eigen::Vector3d axis = Rotation(line.parent.link) * *line.axis;
  return {axis.dot(span),
          span_rate.transpose() * axis + AngularJacobian(line.parent.link).transpose() * axis.cross(span)};
}

Coordinate Kinematics::Twist(const AntiRollBar& bar) const {
  const Coordinate left = LineLength(bar.left);
  const Coordinate right = LineLength(bar.right);
  return {left.value - right.value, left.gradient - right.gradient};
}

Eigen::Matrix3d Kinematics::ChildAxes(const Bushing& bushing) const {
  return Rotation(bushing.child.link).transpose() * Rotation(bushing.parent.link) * bushing.axes;
}

std::array<Coordinate, 6> Kinematics::BushingPlace(const Bushing& bushing, const Eigen::Matrix3d& child_axes) const {
  const Eigen::Matrix3d axes = Rotation(bushing.parent.link) * bushing.axes;
  const Eigen::Vector3d child = Location(bushing.child);
  const SmallTurn turn(axes.transpose() * Rotation(bushing.child.link) * child_axes);
  const Eigen::Vector3d place = axes.transpose() * (child - Location(bushing.parent));
  // As the parent sees it: the parent's own point there moves along.
  const Eigen::MatrixXd shift =
      axes.transpose() * (PointJacobian(bushing.child) - JacobianAt(bushing.parent.link, child));
  const Eigen::MatrixXd spin =
      turn.rate * (axes.transpose() * (AngularJacobian(bushing.child.link) - AngularJacobian(bushing.parent.link)));
  std::array<Coordinate, 6> coordinates;
  for (Eigen::Index i = 0; i < 3; ++i) {
    coordinates[static_cast<std::size_t>(i)] = {place[i], shift.row(i).transpose()};
    coordinates[static_cast<std::size_t>(i + 3)] = {turn.value[i], spin.row(i).transpose()};
  }
  return coordinates;
}

Coordinate Kinematics::FootPosition(const Tyre& tyre, const Eigen::Vector3d& direction) const {
  const TyreFoot foot(Rotation(tyre.point.link), tyre.radius);
  const Coordinate centre = Position(tyre.point, direction);
  return {centre.value + direction.dot(foot.offset),
          centre.gradient + (foot.rate * AngularJacobian(tyre.point.link)).transpose() * direction};
}

}  // namespace fourpost
