#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/subject.h"
#include "identify/experiments/time_history/history_data.h"
#include "vehicles/engine/history_solver.h"

namespace fourpost {

// A fit of histories simulates by the reduced model. Where linear kinematics are off by 0.1 % at the fitted point, the
// difference of the full geometry's signals to the reduced model's there is added to the latter, and the fit goes on
// from there, until the difference changes no more: the residuals at the fitted point are then those of the full
// geometry, their derivatives those of the reduced model.

/// What the full geometry says of one history at one point.
struct HistoryCheck {
  HistoryEngine by;
  /// Samples of the window x signals: to be added to the reduced model's signals; empty: nothing.
  Eigen::MatrixXd correction;
  /// By how much that differs from the correction that was made before: of its signals the largest rms, as a share of
  /// the deviation measured.
  double change = 0;
};

/// Of each history at these values; nothing where `progress` ends it. `error`: of the integration, see
/// HistoryResiduals. `is_corrected`: false for a cost by prediction, whose filter has its own way through a history.
/// Throws as HistorySolver::Solve() does.
std::optional<std::vector<HistoryCheck>> CheckHistories(const Subject& subject,
                                                        const std::vector<MeasuredHistory>& histories, double error,
                                                        bool is_corrected, const std::vector<double>& values,
                                                        const HistorySolver::Progress& progress = {});

/// Whether another fit with these corrections may differ.
bool IsCorrectionDue(const std::vector<HistoryCheck>& checks);

}  // namespace fourpost
