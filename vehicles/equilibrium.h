#pragma once

#include <Eigen/Core>

#include "analysis/diagnostics.h"
#include "vehicles/unheld_motion.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// The least preloads that hold a generalised force w are PreloadMap(holders) w: where a car is statically
/// indeterminate its sides share alike. `holders`: generalised force per unit of each preload that equilibrium sets, in
/// columns; there may be none.
Eigen::MatrixXd PreloadMap(const Eigen::MatrixXd& holders);

/// Static equilibrium in the design pose, sum of given forces + holders times preloads = 0, must have a solution at the
/// file's parameter values and wherever parameters with bounds go. Adds an error for each motion that nothing holds,
/// twins of fp:mirror together; if there is none for each given preload that stands against it.
void CheckEquilibrium(const Vehicle& vehicle, const StaticLoads& loads, Diagnostics& faults);

}  // namespace fourpost
