#pragma once

#include "vehicles/condensed/reduced_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The reduced vehicle of a vehicle, by its multibody system. Throws FaultyInput if the loops cannot be assembled, if
/// nothing can move, or if weights and given preloads have no static equilibrium in the design pose, at the file's
/// values or within the bounds of its parameters (names the elements).
ReducedVehicle Condense(const Vehicle& vehicle);

}  // namespace fourpost
