#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/experiments/time_history/history_data.h"
#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// What is left of an unknown state at the first sample of a record: the vehicle need not have been at rest there, and
/// the posts' first velocity is known as far as noise lets it. Linear about static equilibrium, dashpots by their mean
/// force at 0.1 m/s. Columns: the real and imaginary part of each mode that lasts longer than a sample. Filtered and
/// without the window's mean, as signals are. After ten seconds nothing is left, however long the record.
struct FreeMotion {
  /// Of each signal: the window's first samples x columns.
  std::vector<Eigen::MatrixXd> first;
  /// signals x columns, of every later sample: what the mean took from it.
  Eigen::MatrixXd later;
  /// [s s' x] x columns: the state at the record's first sample.
  Eigen::MatrixXd states;
  /// Of a signal, at these samples of the window.
  Eigen::MatrixXd Rows(Eigen::Index signal, Eigen::Index count, Eigen::Index stride) const;
};

FreeMotion FreeMotionOf(const MeasuredHistory& history, const CondensedModel& model);

/// Of each column, the free motion that brings every `stride`-th sample of `modelled` nearest to the measurement; as of
/// AddStart().
Eigen::VectorXd StartOf(const MeasuredHistory& history, const FreeMotion& motion, const Eigen::VectorXd& weights,
                        Eigen::Index stride, const Eigen::MatrixXd& modelled);

/// Adds to `modelled`, samples of the window x signals, the free motion that brings every `stride`-th sample nearest to
/// the measurement; `weights`: of each signal's squares.
void AddStart(const MeasuredHistory& history, const CondensedModel& model, const Eigen::VectorXd& weights,
              Eigen::Index stride, Eigen::MatrixXd& modelled);

}  // namespace fourpost
