#pragma once

#include "vehicles/description/vehicle.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {

/// A vehicle without a fault, with what `fourpost check` shows of it.
struct CheckedVehicle {
  Vehicle vehicle;
  Mobility mobility;
  VehicleSummary summary;
};

}  // namespace fourpost
