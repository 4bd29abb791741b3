#pragma once

#include <string>
#include <vector>

#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// What `fourpost kinematics` shows on a terminal: of each axle the gradients in the design pose, some positions of
/// each travel, and its compliance.
std::string KinematicsText(const Suspension& suspension, const std::vector<AxleKinematics>& axles);

}  // namespace fourpost
