#pragma once

#include <limits>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Physically possible values of a parameter, SI: a mass, a rate or a friction is not negative, a coordinate is
/// unlimited. Its bounds lie within.
struct PhysicalRange {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// Range of each of Vehicle::parameters, by the signs that the tags of its file require.
std::vector<PhysicalRange> PhysicalRanges(const Vehicle& vehicle);

}  // namespace fourpost
