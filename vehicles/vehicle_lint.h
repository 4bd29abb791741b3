#pragma once

#include "analysis/diagnostics.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// What is odd about a description that reads and assembles; warnings only, each with a remedy. Throws FaultyInput as
/// CondensedVehicle does.
Diagnostics Lint(const Vehicle& vehicle);

}  // namespace fourpost
