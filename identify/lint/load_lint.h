#pragma once

#include "analysis/diagnostics.h"
#include "identify/fit.h"
#include "identify/loaded_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {

/// Static loads after a fit, as warnings: all of them alike heavier or lighter than the forces in motion alone would
/// have them, as with wheelpans weighed along, with the range that the model's own error leaves; else those that are
/// off by more than noise, the misfit of the rest, and friction that holds a car at rest explain. `condensed`: of the
/// study's vehicle.
void LintLoads(const LoadedStudy& study, const FitResult& fit, const CondensedVehicle& condensed,
               Diagnostics& diagnostics);

}  // namespace fourpost
