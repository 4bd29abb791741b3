#pragma once

#include "vehicles/condensed/reduced_data.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// Sets the sensor rows, those of load cells to zero.
void SetSensorRows(const Kinematics& pose, const Vehicle& vehicle, ReducedData& data);

}  // namespace fourpost
