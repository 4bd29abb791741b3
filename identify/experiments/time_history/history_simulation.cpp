#include "identify/experiments/time_history/history_simulation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "analysis/signals/low_pass.h"
#include "analysis/text/option_check.h"
#include "identify/experiments/time_history/findings.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/condensed_stepper.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Metres and metres per second that no vehicle on a rig comes to.
constexpr double kFarthest = 1e6;
/// Steps between looks at the clock: a few milliseconds.
constexpr Index kStepsBetweenChecks = 1000;

Index LeadSamples(const MeasuredHistory& history) { return std::lround(history.posts.lead_s * history.rate_Hz); }

TimeGrid GridOf(const MeasuredHistory& history) {
  return {.start_s = history.posts.start_s,
          .end_s = history.TimeAt(history.count - 1),
          .rate_Hz = history.rate_Hz,
          .lead_s = history.posts.lead_s};
}

/// Samples of the window x signals, of readings, sensors x samples to the end of the window.
Eigen::MatrixXd SignalsOf(const MeasuredHistory& history, const Eigen::MatrixXd& readings) {
  Eigen::MatrixXd out(history.count, static_cast<Index>(history.signals.size()));
  Eigen::VectorXd all(readings.cols());
  for (Index i = 0; i < out.cols(); ++i) {
    all = readings.row(static_cast<Index>(history.signals[static_cast<std::size_t>(i)].sensor));
    if (const auto& filter = history.filter)
      LowPass(filter->order, filter->cutoff_Hz, history.rate_Hz)
          .Apply({all.data(), static_cast<std::size_t>(all.size())});
    out.col(i) = all.tail(history.count);
    out.col(i).array() -= out.col(i).mean();
  }
  return out;
}

}  // namespace

HistorySimulation::HistorySimulation(const MeasuredHistory& history, double step_s)
    : history_(&history),
      parts_(std::max(1L, std::lround(std::ceil(1 / (history.rate_Hz * step_s) - 1e-9)))),
      samples_(LeadSamples(history) + history.first + history.count) {
  const double start = history.posts.start_s - history.posts.lead_s;
  const Index steps = (samples_ - 1) * parts_ + 1;
  post_count_ = static_cast<Index>(history.posts.count);
  posts_.resize(static_cast<std::size_t>(steps * post_count_));
  for (Index k = 0; k < steps; ++k)
    history.posts.motion(start + static_cast<double>(k) * this->step_s(),
                         {posts_.data() + k * post_count_, static_cast<std::size_t>(post_count_)});
}

std::span<const PostState> HistorySimulation::PostsAt(Index step) const {
  return {posts_.data() + step * post_count_, static_cast<std::size_t>(post_count_)};
}

template <typename Sample>
void HistorySimulation::March(const CondensedModel& model, const Deadline& deadline, const Sample& sample) const {
  CondensedStepper stepper(model, step_s());
  stepper.Start(PostsAt(0));
  for (Index k = 0; k < samples_; ++k) {
    if (k % kStepsBetweenChecks == 0) deadline.Check();
    for (long part = 0; part < parts_ && k > 0; ++part) stepper.Step(PostsAt((k - 1) * parts_ + part + 1));
    sample(k, stepper);
    // So written that it is true for NaN.
    if (!(stepper.state().norm() < kFarthest)) throw SimulationError(kMotionUnbounded);
  }
  if (stepper.unsolved_steps() > 0) throw SimulationError(kForcesUnsolved, {std::to_string(stepper.unsolved_steps())});
}

Eigen::MatrixXd HistorySimulation::Run(const CondensedModel& model, const Deadline& deadline) const {
  Eigen::MatrixXd readings(model.on_position.rows(), samples_);
  March(model, deadline, [&](Index k, const CondensedStepper& stepper) { stepper.Read(readings.col(k)); });
  Eigen::MatrixXd signals = SignalsOf(*history_, readings);
  if (history_->correction.size() > 0) signals += history_->correction;
  return signals;
}

Eigen::MatrixXd HistorySimulation::Readings(const CondensedModel& model) const {
  Eigen::MatrixXd readings(model.on_position.rows(), samples_);
  March(model, {}, [&](Index k, const CondensedStepper& stepper) { stepper.Read(readings.col(k)); });
  return readings.rightCols(history_->count).transpose();
}

HistoryMotion HistorySimulation::Motion(const CondensedModel& model, Index stride) const {
  RequireOption(stride >= 1, "HistorySimulation::Motion: stride", static_cast<double>(stride), "at least 1");
  const Index first = samples_ - history_->count;
  const Index frames = (history_->count - 1) / stride + 1;
  HistoryMotion motion{.start_s = history_->TimeAt(0), .rate_Hz = history_->rate_Hz / static_cast<double>(stride)};
  motion.posts.resize(frames, post_count_);
  motion.coordinates.resize(frames, model.mass.rows());
  March(model, {}, [&](Index k, const CondensedStepper& stepper) {
    if (k < first || (k - first) % stride != 0) return;
    const Index frame = (k - first) / stride;
    const std::span<const PostState> posts = PostsAt(k * parts_);
    for (Index p = 0; p < post_count_; ++p) motion.posts(frame, p) = posts[static_cast<std::size_t>(p)].height;
    motion.coordinates.row(frame) = stepper.state().head(model.mass.rows()).transpose();
  });
  return motion;
}

std::optional<EngineHistory> SimulateBy(const HistorySolver::Options& options, const MeasuredHistory& history,
                                        const Vehicle& vehicle, const std::vector<double>& values,
                                        const HistorySolver::Progress& progress) {
  Vehicle measured = vehicle;
  measured.sensors.clear();
  MeasuredHistory numbered = history;
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    measured.sensors.push_back(vehicle.sensors[history.signals[i].sensor]);
    numbered.signals[i].sensor = i;
  }
  const SolvedHistory solved =
      HistorySolver(measured, values).Solve(history.posts.motion, GridOf(history), options, progress);
  if (solved.ended) return std::nullopt;
  return EngineHistory{.modelled = SignalsOf(numbered, solved.history.readings.transpose()), .by = solved.by};
}

double HistoryStep(const MeasuredHistory& history, const CondensedModel& model, const RigView& rig, double error) {
  return SimulateCondensed(model, rig, history.posts.motion, GridOf(history), {.error = error}).step_s;
}

}  // namespace fourpost
