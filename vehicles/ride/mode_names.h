#pragma once

#include <vector>

#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

/// Names modes by the bodies that carry their kinetic energy, and sets the shares.
///   Chassis: fore-aft, lateral, heave, roll, pitch, yaw; it names the mode if it has half of the energy or more.
///   A body that moves with one axle, such as a beam axle: fore-aft, lateral, hop, tramp, wind-up, steer of that axle.
///   A body that moves with one wheel: hop if the wheels of the axle move alike, tramp if against each other, as in
///   "front hop"; "front left hop" if one side has nine tenths of both.
///   Any other body by its name: "engine roll".
/// A body moves with a wheel if raising the wheel, chassis held, lifts it by a tenth of the wheel's rise or more.
/// Repeated names are numbered. Rigid-body modes are separated first, see NameMotions. `pose`: the design pose.
void NameModes(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension, const HeldChassis& held,
               std::vector<Mode>& modes);

}  // namespace fourpost
