#pragma once

#include "identify/fit.h"
#include "identify/search/evaluation_store.h"
#include "identify/vehicle_objective.h"

namespace fourpost {

/// Fit(), showing how it gets on; an interrupt by the user ends it with what it has.
FitResult FitWithProgress(const VehicleObjective& objective, const FitOptions& options, EvaluationStore& store);

}  // namespace fourpost
