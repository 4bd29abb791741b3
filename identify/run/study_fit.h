#pragma once

#include "identify/fit/fit.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/study/study.h"

namespace fourpost {

/// How a study wants to be fitted: it looks first at what the data determine. Throws FaultyInput for settings of its
/// method that there are not.
FitOptions FitOptionsOf(const Study& study, const VehicleObjective& objective);

}  // namespace fourpost
