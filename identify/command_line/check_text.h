#pragma once

#include <string>

#include "identify/command_line/checked_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What `fourpost check` prints: bodies, masses, loads, rates, modes, posts, sensors, parameters and what
/// sees them.
std::string CheckText(const CheckedVehicle& checked);

/// "accelerometer".
const char* KindName(Sensor::Type type);

/// "revolute y": how the joint lets its child move, the axis in the child's frame.
std::string DescribeJoint(const Joint& joint);

}  // namespace fourpost
