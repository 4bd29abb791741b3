#pragma once

#include <vector>

#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

/// Names modes by what carries their kinetic energy, and tells the shares.
///   Chassis: fore-aft, lateral, heave, roll, pitch, yaw; it gives its name when it has half of the energy or more.
///   A body that moves with one axle, such as a beam axle: fore-aft, lateral, hop, tramp, wind-up, steer of that axle.
///   A body that moves with one wheel: hop when the wheels of the axle move alike, tramp when against each other, as
///   "front hop"; "front left hop" when one side has nine tenths of both.
///   Any other body by its name: "engine roll".
/// A body moves with a wheel that lifts it, chassis held, by a tenth of the wheel's rise or more. Names that come again
/// are numbered. Free motions are told apart first, see NameMotions. `pose`: the design pose.
void NameModes(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension, const HeldChassis& held,
               std::vector<Mode>& modes);

}  // namespace fourpost
