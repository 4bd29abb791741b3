#pragma once

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {

/// What `fourpost check` finds odd in how the assembled vehicle rides: a motion that grows, a wheel rate that no
/// suspension has, a coil or damper that hardly follows its wheel or runs ahead of it. Such come from one coordinate
/// mistyped, which no number tells by itself.
Diagnostics LintRide(const Vehicle& vehicle, const VehicleSummary& summary);

}  // namespace fourpost
