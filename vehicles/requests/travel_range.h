#pragma once

#include <string>

#include "analysis/text/diagnostics.h"
#include "vehicles/poses/axle_kinematics.h"

namespace fourpost {

/// `travel`: "80mm" both ways, or rebound and bump, "-60mm:80mm"; empty: to the stops. `step`: "5mm". Adds errors of
/// the options --travel and --step.
TravelRange ReadTravelRange(const std::string& travel, const std::string& step, Diagnostics& findings);

}  // namespace fourpost
