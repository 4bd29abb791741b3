#include "vehicles/multibody/kinematics.h"

#include "vehicles/multibody/small_turn.h"
#include "vehicles/multibody/tyre_foot.h"

namespace fourpost {

Kinematics::Kinematics(const Multibody& multibody) {
  const int links = static_cast<int>(multibody.vehicle().links.size());
  for (int link = 0; link < links; ++link) {
    pose_.push_back(multibody.LinkPose(link));
    jacobian_.emplace_back(multibody.LinkJacobian(link));
  }
}

Kinematics::Kinematics(const Multibody& multibody, const Eigen::MatrixXd& tangent) {
  const int links = static_cast<int>(multibody.vehicle().links.size());
  for (int link = 0; link < links; ++link) {
    pose_.push_back(multibody.LinkPose(link));
    jacobian_.emplace_back(multibody.LinkJacobian(link) * tangent);
  }
}

Eigen::Vector3d Kinematics::Location(const Point& point) const {
  return pose_[static_cast<std::size_t>(point.link)] * point.xyz;
}

Eigen::Matrix3d Kinematics::Rotation(int link) const { return pose_[static_cast<std::size_t>(link)].linear(); }

Eigen::MatrixXd Kinematics::AngularJacobian(int link) const {
  return jacobian_[static_cast<std::size_t>(link)].topRows<3>();
}

Eigen::MatrixXd Kinematics::PointJacobian(const Point& point) const {
  const auto& jacobian = jacobian_[static_cast<std::size_t>(point.link)];
  return jacobian.bottomRows<3>() - Cross(Arm(point.link, Location(point))) * jacobian.topRows<3>();
}

Eigen::Vector3d Kinematics::Arm(int link, const Eigen::Vector3d& place) const {
  return place - pose_[static_cast<std::size_t>(link)].translation();
}

// (v + w x arm) . d = v . d + w . (arm x d).
Eigen::VectorXd Kinematics::Along(int link, const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const {
  Eigen::Matrix<double, 6, 1> turn_and_shift;
  turn_and_shift << Arm(link, place).cross(direction), direction;
  return jacobian_[static_cast<std::size_t>(link)].transpose() * turn_and_shift;
}

Eigen::VectorXd Kinematics::About(int link, const Eigen::Vector3d& axis) const {
  return jacobian_[static_cast<std::size_t>(link)].topRows<3>().transpose() * axis;
}

Coordinate Kinematics::Position(const Point& point, const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d place = Location(point);
  return {direction.dot(place), Along(point.link, place, direction)};
}

Coordinate Kinematics::LineLength(const ForceLine& line) const {
  const Eigen::Vector3d parent = Location(line.parent);
  const Eigen::Vector3d child = Location(line.child);
  const Eigen::Vector3d span = parent - child;
  if (!line.axis) {
    const double length = span.norm();
    const Eigen::Vector3d along = span / length;
    return {length, Along(line.parent.link, parent, along) - Along(line.child.link, child, along)};
  }
  // The axis turns with the parent, as if the parent's own point at the child's place moved.
  const Eigen::Vector3d axis = Rotation(line.parent.link) * *line.axis;
  return {axis.dot(span), Along(line.parent.link, child, axis) - Along(line.child.link, child, axis)};
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
  std::array<Coordinate, 6> coordinates;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = axes.col(i);
    const Eigen::Vector3d turn_axis = axes * turn.rate.row(i).transpose();
    // As the parent sees it: the parent's own point there moves along.
    coordinates[static_cast<std::size_t>(i)] = {
        place[i], Along(bushing.child.link, child, axis) - Along(bushing.parent.link, child, axis)};
    coordinates[static_cast<std::size_t>(i + 3)] = {
        turn.value[i], About(bushing.child.link, turn_axis) - About(bushing.parent.link, turn_axis)};
  }
  return coordinates;
}

Coordinate Kinematics::FootPosition(const Tyre& tyre, const Eigen::Vector3d& direction) const {
  const TyreFoot foot(Rotation(tyre.point.link), tyre.radius);
  const Eigen::Vector3d centre = Location(tyre.point);
  return {direction.dot(centre + foot.offset),
          Along(tyre.point.link, centre, direction) + About(tyre.point.link, foot.rate.transpose() * direction)};
}

}  // namespace fourpost
