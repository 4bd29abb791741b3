#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Poses of the links in the ground in the design pose, all joint coordinates zero; one per link.
std::vector<Eigen::Isometry3d> DesignPoses(const Vehicle& vehicle);

/// Position of a point in ground axes, given these poses [m].
Eigen::Vector3d PlaceOf(const Point& point, const std::vector<Eigen::Isometry3d>& poses);

}  // namespace fourpost
