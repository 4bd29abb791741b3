#pragma once

#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A displacement sensor for each independent coordinate of the model.
std::vector<Sensor> CoordinateSensors(const CondensedModel& model);

/// The model that reads its coordinates in place of its own sensors.
CondensedModel WithCoordinatesAsSensors(CondensedModel model);

}  // namespace fourpost
