#pragma once

#include <limits>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Values of a parameter, SI, with which all numbers that it stands for may be: a mass, a rate or a friction is not
/// negative, a coordinate is anything. Its bounds lie within.
struct PhysicalRange {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// Of each of Vehicle::parameters, by the signs that the tags of its file ask for.
std::vector<PhysicalRange> PhysicalRanges(const Vehicle& vehicle);

}  // namespace fourpost
