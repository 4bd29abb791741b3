#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_data.h"
#include "identify/experiments/time_history/kalman_predictor.h"
#include "identify/residuals/history_misfit.h"
#include "identify/residuals/yardstick.h"

namespace fourpost {

/// Adds the errors of one-step predictions.
void AddOneStepErrors(const std::vector<MeasuredHistory>& histories, const std::vector<KalmanPrediction>& predictions,
                      std::vector<HistoryMisfit>& misfits);

/// Adds the errors of the reduced model through one history, `misfits` of its signals.
void AddReducedErrors(const MeasuredHistory& history, const Eigen::MatrixXd& modelled,
                      std::span<HistoryMisfit> misfits);

/// How well models show each signal of each history; `modelled` as HistoryResiduals::Modelled gives it.
std::vector<HistoryMisfit> HistoryMisfits(const std::vector<MeasuredHistory>& histories,
                                          const std::vector<Eigen::MatrixXd>& modelled);

/// For AddYardsticks(): heights of the posts and signals within the windows, of each the longest stretch in which all
/// was measured.
std::vector<YardstickRecord> YardstickRecords(const std::vector<MeasuredHistory>& histories);

}  // namespace fourpost
