#pragma once

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/unheld_motion.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Static equilibrium in the design pose, sum of given forces + holders times preloads = 0, must have a solution at the
/// file's parameter values and for all values within their bounds. Adds an error for each motion that nothing holds,
/// mirror partners together; if there is none, an error for each given preload that contradicts equilibrium.
void CheckEquilibrium(const Vehicle& vehicle, const StaticLoads& loads, Diagnostics& faults);

}  // namespace fourpost
