#pragma once

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Whether this is a damper between the clamps of a bench and no car that lacks something: one link that moves, held
/// and driven by the rig, with a damper and neither tyre nor sensor. The bench itself sets the stroke and reads the
/// force.
bool IsBenchVehicle(const Vehicle& vehicle);

}  // namespace fourpost
