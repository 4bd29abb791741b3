#pragma once

#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// Elements named as left and right whose points are nearly, but not quite, mirror images at y = 0. Sensors are left
/// out: their positions depend on the available space.
void LintMirroredPoints(const DrawnVehicle& drawn, FileFaults& findings);

/// Elements named as left and right with numbers that differ by more than 1 % if both are typed, or by more than a
/// factor of 1.5 if a parameter gives one of them.
void LintMirroredNumbers(const DrawnVehicle& drawn, FileFaults& findings);

/// Anti-roll bars whose two lines are on one side of the car.
void LintBarSides(const DrawnVehicle& drawn, FileFaults& findings);

}  // namespace fourpost
