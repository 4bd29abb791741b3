#include "vehicles/simulation/time_system.h"

#include <algorithm>

#include "vehicles/description/design_poses.h"

namespace fourpost {
namespace {

double LeverOfPosts(const Vehicle& vehicle) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  double distance = 0;
  for (const Post& one : vehicle.posts)
    for (const Post& other : vehicle.posts) {
      const Eigen::Vector3d between = PlaceOf(vehicle.tyres[static_cast<std::size_t>(one.tyre)].point, poses) -
                                      PlaceOf(vehicle.tyres[static_cast<std::size_t>(other.tyre)].point, poses);
      distance = std::max(distance, between.head<2>().norm());
    }
  return distance > 0 ? distance / 2 : 1;
}

double StiffestTyre(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  double stiffness = 0;
  for (const Tyre& tyre : vehicle.tyres) stiffness = std::max(stiffness, tyre.law.RateAt(values, 0));
  return stiffness;
}

}  // namespace

RigView RigViewOf(const Vehicle& vehicle) {
  return {vehicle.sensors, vehicle.posts.size(), LeverOfPosts(vehicle), StiffestTyre(vehicle),
          vehicle.actuators.size()};
}

}  // namespace fourpost
