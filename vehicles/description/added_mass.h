#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Index of the link of the largest mass, the vehicle's body.
std::size_t HeaviestLink(const Vehicle& vehicle, std::span<const double> parameters);

/// A vehicle with a point mass fixed to its heaviest link: mass, centre of mass and inertia of that link become
/// numbers, at these values of the parameters. `place`: in ground axes, in the design pose [m]. The vehicle keeps its
/// design pose: preloads that equilibrium sets carry the load, as if springs had been screwed up to level it. Throws
/// std::invalid_argument unless the mass is above zero and finite.
Vehicle WithMass(const Vehicle& vehicle, std::span<const double> parameters, double mass, const Eigen::Vector3d& place);

}  // namespace fourpost
