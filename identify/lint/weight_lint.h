#pragma once

#include "analysis/diagnostics.h"
#include "identify/loaded_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

/// Static loads that no masses within their bounds make. `condensed`: of the study's vehicle.
void LintWeights(const LoadedStudy& study, const CondensedVehicle& condensed, Diagnostics& diagnostics);

}  // namespace fourpost
