#include "vehicles/description/added_mass.h"

#include <algorithm>
#include <cmath>

#include "analysis/text/option_check.h"
#include "vehicles/description/design_poses.h"

namespace fourpost {
namespace {

Eigen::Matrix3d InertiaAt(const Link& link, std::span<const double> parameters) {
  std::array<double, 6> i{};
  for (std::size_t k = 0; k < i.size(); ++k) i[k] = link.inertia[k].At(parameters);
  Eigen::Matrix3d inertia;
  inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  return inertia;
}

/// Of a point mass about a point at this distance.
Eigen::Matrix3d PointInertia(double mass, const Eigen::Vector3d& distance) {
  return mass * (distance.squaredNorm() * Eigen::Matrix3d::Identity() - distance * distance.transpose());
}

}  // namespace

std::size_t HeaviestLink(const Vehicle& vehicle, std::span<const double> parameters) {
  const auto lighter = [&](const Link& a, const Link& b) { return a.mass.At(parameters) < b.mass.At(parameters); };
  return static_cast<std::size_t>(std::max_element(vehicle.links.begin(), vehicle.links.end(), lighter) -
                                  vehicle.links.begin());
}

Vehicle WithMass(const Vehicle& vehicle, std::span<const double> parameters, double mass,
                 const Eigen::Vector3d& place) {
  RequireOption(mass > 0 && std::isfinite(mass), "mass", mass, "positive and finite");
  Vehicle loaded = vehicle;
  const std::size_t heaviest = HeaviestLink(vehicle, parameters);
  Link* const body = &loaded.links[heaviest];
  const Eigen::Isometry3d pose = DesignPoses(vehicle)[heaviest];
  const double own = body->mass.At(parameters);
  const Eigen::Vector3d own_com = body->ComAt(parameters);
  const Eigen::Vector3d at = pose.inverse() * place;
  const Eigen::Vector3d com = (own * own_com + mass * at) / (own + mass);
  const Eigen::Matrix3d inertia =
      InertiaAt(*body, parameters) + PointInertia(own, own_com - com) + PointInertia(mass, at - com);
  body->mass = {.value = own + mass};
  for (int k = 0; k < 3; ++k) body->com[static_cast<std::size_t>(k)] = {.value = com[k]};
  const std::array<double, 6> numbers = {inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                         inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  for (std::size_t k = 0; k < numbers.size(); ++k) body->inertia[k] = {.value = numbers[k]};
  return loaded;
}

}  // namespace fourpost
