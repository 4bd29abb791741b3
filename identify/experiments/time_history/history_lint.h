#pragma once

#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "identify/experiments/time_history/history_study.h"
#include "identify/residuals/history_misfit.h"

namespace fourpost {

/// Implausible time histories, as warnings at their lines of the study: RemarksOn the fitted
/// vehicle; channels swapped, and posts that are not synchronised, at the values of the vehicle's file, which a fit may
/// hide by its parameters; displacements and accelerations of one point that are not synchronised; and steps that are
/// too long for the fitted values. One cause is reported once. `misfits`: of `residuals` at the fitted values.
/// `study_file`, `stated`: where they stand; `values`: fitted ones, of all parameters; `modelled`: by the residuals at
/// these.
void LintHistories(const std::string& study_file, const std::vector<StudyHistory>& stated, const Vehicle& vehicle,
                   const std::vector<double>& values, const HistoryResiduals& residuals,
                   const std::vector<Eigen::MatrixXd>& modelled, const std::vector<HistoryMisfit>& misfits,
                   Diagnostics& diagnostics);

}  // namespace fourpost
