#pragma once

#include "vehicles/file_faults.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// Reports bodies that cannot be: inertia that no mass distribution has, anywhere within the bounds of the parameters,
/// and joints that move no mass.
void CheckBodies(const Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
