#pragma once

#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/poses/suspension_rig.h"

namespace fourpost {

/// A page of the kinematics and compliance of a vehicle: of each axle gradients, curves over its travels and
/// compliances, and the vehicle on its rig, in full geometry, through every travel. `axles`: of this rig.
std::string KinematicsPage(SuspensionRig& rig, const std::vector<AxleKinematics>& axles, const Diagnostics& findings);

}  // namespace fourpost
