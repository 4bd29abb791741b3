#pragma once

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {

/// Plausibility checks of `fourpost check` on the assembled vehicle: an unstable motion, an unusual wheel rate, a coil
/// or damper with a motion ratio near zero or above one. One mistyped coordinate causes such findings, although each
/// number alone looks plausible.
Diagnostics LintRide(const Vehicle& vehicle, const VehicleSummary& summary);

}  // namespace fourpost
