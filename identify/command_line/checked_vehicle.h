#pragma once

#include "vehicles/mobility.h"
#include "vehicles/vehicle.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {

/// A vehicle without a fault, with what `fourpost check` tells of it.
struct CheckedVehicle {
  Vehicle vehicle;
  Mobility mobility;
  VehicleSummary summary;
};

}  // namespace fourpost
