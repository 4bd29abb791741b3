#pragma once

#include "analysis/text/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Plausibility checks of a valid description, whether it assembles or not; warnings only, each with a remedy.
Diagnostics LintDescription(const Vehicle& vehicle);

/// Plausibility checks of the assembled vehicle, at rest and in motion; warnings only, each with a remedy. Throws
/// FaultyInput as CondensedVehicle does.
Diagnostics LintAssembled(const Vehicle& vehicle);

}  // namespace fourpost
