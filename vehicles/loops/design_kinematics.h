#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// The geometry of a vehicle in its design pose, in the same independent coordinates as its CondensedVehicle. Throws
/// FaultyInput if the loops cannot be assembled.
Kinematics DesignKinematics(const Vehicle& vehicle);

}  // namespace fourpost
