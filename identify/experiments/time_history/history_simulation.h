#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/deadline.h"
#include "identify/experiments/recorded_motion.h"
#include "identify/experiments/time_history/history_data.h"
#include "identify/experiments/time_history/release.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/simulation/time_history.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

/// A model through a measured history: the posts move as the rig's did, what the sensors read goes through the rig's
/// filter, once, and loses its mean over the window. Filtering the model's outputs is right although the record's post
/// heights are filtered too: FollowHeights takes that back. To drive the model with filtered heights in place of that
/// is the same for a linear model only; friction and dampers see the amplitude, which the filter takes away.
/// Immutable; serves any number of threads.
class HistorySimulation {
 public:
  /// `step_s`: of the condensed stepper; whole parts of a sample are taken, none longer. The history must outlive this.
  HistorySimulation(const MeasuredHistory& history, double step_s);

  /// Of a release: [s s' x] at the first sample of the window, as held or estimated from the signals, and how well.
  struct Start {
    Eigen::VectorXd state;
    EstimatedStart estimate;
  };
  Start StartOf(const CondensedModel& model, const Deadline& deadline = {}) const;
  /// Its state; empty without a release.
  Eigen::VectorXd StateOf(const CondensedModel& model, const Deadline& deadline = {}) const;

  /// Samples of the window x signals, the history's correction included. Throws std::runtime_error where the motion
  /// cannot be computed, and TimedOut.
  Eigen::MatrixXd Run(const CondensedModel& model, const Deadline& deadline = {}) const;

  /// From this state; empty: from rest.
  Eigen::MatrixXd Run(const CondensedModel& model, const Eigen::VectorXd& state, const Deadline& deadline) const;

  /// From rest, and with `offset` added to the state [s s' x] at the record's first sample. Not for a release, nor for
  /// hydraulic dampers, whose oil has states of its own.
  Eigen::MatrixXd RunWithOffset(const CondensedModel& model, const Eigen::VectorXd& offset) const;

  /// What Run() gives for each neighbour of a model, to first order in their difference: see MotionSensitivity, whose
  /// Covers() must hold. Not for a release, whose start depends on the model. Throws as Run() does.
  std::vector<Eigen::MatrixXd> RunNear(const CondensedModel& model, std::span<const CondensedModel> neighbours) const;

  /// What the sensors of a model read without the filter, samples of the window x sensors. Throws as Run() does.
  /// `state`: as of Run(); of a vehicle with the same bodies, other sensors than the recording's may be read.
  Eigen::MatrixXd Readings(const CondensedModel& model, const Eigen::VectorXd& state = {}) const;

  /// What moved while that was so: the first sample of the window and every `stride`-th after it, at least 1. No filter
  /// is between. Throws as Run() does.
  HistoryMotion Motion(const CondensedModel& model, Eigen::Index stride) const;

  double step_s() const { return 1 / (history_->rate_Hz * static_cast<double>(parts_)); }

 private:
  /// `sample(k, stepper)` after the steps to each sample.
  template <typename Sample>
  void March(const CondensedModel& model, const Deadline& deadline, const Sample& sample) const;
  /// From this state; empty: from rest.
  template <typename Sample>
  void March(const CondensedModel& model, const Eigen::VectorXd& state, const Deadline& deadline,
             const Sample& sample) const;
  /// `follow(stepper)` at the start and after each step.
  template <typename Follow, typename Sample>
  void March(const CondensedModel& model, const Eigen::VectorXd& state, const Deadline& deadline, const Follow& follow,
             const Sample& sample) const;
  std::span<const PostState> PostsAt(Eigen::Index step) const;

  const MeasuredHistory* history_;
  long parts_ = 1;
  Eigen::Index post_count_ = 0;
  /// Posts of each step, one step after the other, from the start of the lead to the end of the window.
  std::vector<PostState> posts_;
  Eigen::Index samples_ = 0;
  /// Of these, before the record's first one.
  Eigen::Index lead_ = 0;
};

/// What an engine makes of a measured history.
struct EngineHistory {
  /// Samples of the window x signals, see HistorySimulation::Run.
  Eigen::MatrixXd modelled;
  HistoryEngine by;
  /// Of a release, from where: see HistorySimulation::Start; else empty.
  Eigen::VectorXd released = {};
};

/// The vehicle at these values through the history. Only sensors that were measured count in what linear kinematics are
/// off by, before the rig's filter. Nothing where `progress` ends it. Throws as HistorySolver::Solve() does.
std::optional<EngineHistory> SimulateBy(const HistorySolver::Options& options, const MeasuredHistory& history,
                                        const Vehicle& vehicle, const std::vector<double>& values,
                                        const HistorySolver::Progress& progress = {});

/// The step at which a model errs by no more than `error` of any channel's rms, by halving (SimulateCondensed).
double HistoryStep(const MeasuredHistory& history, const CondensedModel& model, const RigView& rig, double error);

}  // namespace fourpost
