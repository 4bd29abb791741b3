#pragma once

#include <string>

#include "vehicles/mobility.h"
#include "vehicles/vehicle.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {

/// What `fourpost check --json` prints. Units stand in the keys, angles in rad; what is not known is null, and so is a
/// rate without bound.
std::string CheckJson(const Vehicle& vehicle, const VehicleSummary& summary, const Mobility& mobility);

}  // namespace fourpost
