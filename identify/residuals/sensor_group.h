#pragma once

#include <cstddef>
#include <string>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The kind of a sensor on a kind of link, the same for all corners of a vehicle: "tyre forces", "struts",
/// "accelerations of wheels", "accelerations of body". A link that carries a tyre is of the wheels; others go by their
/// names. `sensor`: place in Vehicle::sensors.
std::string SensorGroup(const Vehicle& vehicle, std::size_t sensor);

}  // namespace fourpost
