#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Reports impossible bodies: inertia that no mass distribution has, anywhere within the bounds of the parameters, and
/// joints that move no mass.
void CheckBodies(const Vehicle& vehicle, FileFaults& faults);

/// Reports elements that act along the line between their ends when the ends coincide in the design pose.
void CheckLengths(const Vehicle& vehicle, FileFaults& faults);

/// Reports tyres with a radius whose wheel's axis, the y axis of their link, does not point sideways in the design
/// pose.
void CheckWheels(const Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
