#pragma once

#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Accelerometers and displacement sensors far from the body that carries them.
void LintSensorPlaces(const DrawnVehicle& drawn, FileFaults& findings);

/// Inertias that no body has whose mass lies about where its elements, shapes and centre of mass are.
void LintInertias(const DrawnVehicle& drawn, FileFaults& findings);

/// Tyres that do not stand on the platform's height, z = 0.
void LintTyreHeights(const DrawnVehicle& drawn, FileFaults& findings);

/// Springs and dampers between points that are too close or too far apart.
void LintLengths(const DrawnVehicle& drawn, FileFaults& findings);

/// Tyres without a post.
void LintPosts(const DrawnVehicle& drawn, FileFaults& findings);

/// A vehicle without a sensor.
void LintSensors(const DrawnVehicle& drawn, FileFaults& findings);

}  // namespace fourpost
