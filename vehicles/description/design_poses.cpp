#include "vehicles/description/design_poses.h"

namespace fourpost {

std::vector<Eigen::Isometry3d> DesignPoses(const Vehicle& vehicle) {
  std::vector<Eigen::Isometry3d> poses(vehicle.links.size(), Eigen::Isometry3d::Identity());
  for (const Joint& joint : vehicle.joints)
    poses[static_cast<std::size_t>(joint.child)] = poses[static_cast<std::size_t>(joint.parent)] * joint.pose;
  return poses;
}

Eigen::Vector3d PlaceOf(const Point& point, const std::vector<Eigen::Isometry3d>& poses) {
  return poses[static_cast<std::size_t>(point.link)] * point.xyz;
}

}  // namespace fourpost
