#pragma once

#include "analysis/diagnostics.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// What is odd about a description that reads, whether it assembles or not; warnings only, each with a remedy.
Diagnostics LintDescription(const Vehicle& vehicle);

/// What is odd about the vehicle as it assembles, stands and moves; warnings only, each with a remedy. Throws
/// FaultyInput as CondensedVehicle does.
Diagnostics LintAssembled(const Vehicle& vehicle);

}  // namespace fourpost
