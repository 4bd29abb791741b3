#pragma once

#include "analysis/diagnostics.h"
#include "vehicles/condensed/unheld_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Static equilibrium in the design pose, sum of given forces + holders times preloads = 0, must have a solution at the
/// file's parameter values and wherever parameters with bounds go. Adds an error for each motion that nothing holds,
/// twins of fp:mirror together; if there is none for each given preload that stands against it.
void CheckEquilibrium(const Vehicle& vehicle, const StaticLoads& loads, Diagnostics& faults);

}  // namespace fourpost
