#pragma once

#include <vector>

#include "analysis/diagnostics.h"
#include "identify/fit.h"
#include "identify/history_residuals.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"

namespace fourpost {

/// What in recordings over time can hardly be so, as warnings at their lines of the study: RemarksOn the fitted
/// vehicle; channels swapped, and posts that are not synchronised, at the values of the vehicle's file, which a fit may
/// hide by its parameters; displacements and accelerations of one point that are not synchronised; and steps that are
/// too long for the fitted values. One cause is told once. `misfits`: of `residuals` at the fitted values.
void LintHistories(const LoadedStudy& study, const FitResult& fit, const HistoryResiduals& residuals,
                   const std::vector<HistoryMisfit>& misfits, Diagnostics& diagnostics);

}  // namespace fourpost
