#include "vehicles/kinematics.h"

namespace fourpost {
namespace {

Eigen::Matrix3d Cross(const Eigen::Vector3d& v) {
  Eigen::Matrix3d cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return cross;
}

}  // namespace

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

Eigen::MatrixXd Kinematics::PointJacobian(const Point& point) const {
  const Eigen::Vector3d arm = Rotation(point.link) * point.xyz;
  return jacobian_[static_cast<std::size_t>(point.link)].bottomRows<3>() - Cross(arm) * AngularJacobian(point.link);
}

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

}  // namespace fourpost
