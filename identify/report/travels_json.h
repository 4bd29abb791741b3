#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/poses/suspension_rig.h"

namespace fourpost {

/// The vehicle in each position of each travel, for the key `travels` of a scene in analysis/report/README.md. `axles`:
/// of this rig.
nlohmann::ordered_json TravelsJson(SuspensionRig& rig, const std::vector<AxleKinematics>& axles);

}  // namespace fourpost
