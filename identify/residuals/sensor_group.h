#pragma once

#include <cstddef>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What a sensor shows, the same for all corners of a vehicle: "tyre forces", "struts", "motion of wheels", "motion of
/// body". Accelerations and displacements of a link show one motion: without either the other says the same. A link
/// that carries a tyre is of the wheels; others go by their names. `sensor`: place in Vehicle::sensors.
std::string SensorGroup(const Vehicle& vehicle, std::size_t sensor);

}  // namespace fourpost
