#pragma once

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"

namespace fourpost {

/// The sensor rows of a CondensedModel, as far as they do not depend on parameters: those of load cells are zero.
CondensedModel SensorRows(const Kinematics& pose, const Vehicle& vehicle, Eigen::Index coordinates);

}  // namespace fourpost
