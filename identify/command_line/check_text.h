#pragma once

#include <string>

#include "vehicles/mobility.h"
#include "vehicles/vehicle.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {

/// What `fourpost check` prints: bodies, masses, loads, rates, modes, parameters and what sees them.
std::string CheckText(const Vehicle& vehicle, const VehicleSummary& summary, const Mobility& mobility);

/// "revolute y": how the joint lets its child move, the axis in the child's frame.
std::string DescribeJoint(const Joint& joint);

}  // namespace fourpost
