#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// The geometry of a vehicle in its design pose, by the independent coordinates that its CondensedVehicle has too.
/// Throws FaultyInput when the loops cannot be assembled.
Kinematics DesignKinematics(const Vehicle& vehicle);

}  // namespace fourpost
