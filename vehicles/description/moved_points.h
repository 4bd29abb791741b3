#pragma once

#include <span>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// For each parameter, whether points of the vehicle move with it.
std::vector<bool> MovePoints(const Vehicle& vehicle);

/// The vehicle with its points where these values of the parameters have them [SI, order of Vehicle::parameters]; all
/// else stays. Rods become as long as the new points are apart, and balls stay closed where both of their points shift
/// alike. Throws std::invalid_argument for another number of values.
Vehicle WithPointsAt(Vehicle vehicle, std::span<const double> parameters);

}  // namespace fourpost
