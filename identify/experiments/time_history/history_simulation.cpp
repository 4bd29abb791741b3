#include "identify/experiments/time_history/history_simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/drift.h"
#include "analysis/signals/low_pass.h"
#include "analysis/text/option_check.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/findings.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/condensed_stepper.h"
#include "vehicles/simulation/motion_sensitivity.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Metres and metres per second that no vehicle on a rig comes to.
constexpr double kFarthest = 1e6;
/// Steps between looks at the clock: a few milliseconds.
constexpr Index kStepsBetweenChecks = 1000;
/// Of neighbours that are followed together: 256 MB.
constexpr std::size_t kMostReadings = 32'000'000;
/// At which a release is estimated before the step is known [s].
constexpr double kLongestStep_s = 1e-3;

/// Samples before the window: from the release on nothing before it counts.
Index SamplesBefore(const MeasuredHistory& history) {
  return history.release ? 0 : std::lround(history.posts.lead_s * history.rate_Hz) + history.first;
}

double StartOfMotion_s(const MeasuredHistory& history) {
  return history.release ? history.TimeAt(0) : history.posts.start_s - history.posts.lead_s;
}

/// What a filter has come to before a release: displacements were held, nothing else was there.
double HeldReading(const MeasuredHistory& history, const MeasuredSignal& signal, double first) {
  return history.release && ParseUnit(signal.unit)->dimension == kLength ? first : 0;
}

TimeGrid GridOf(const MeasuredHistory& history) {
  if (history.release)
    return {.start_s = history.TimeAt(0), .end_s = history.TimeAt(history.count - 1), .rate_Hz = history.rate_Hz};
  return {.start_s = history.posts.start_s,
          .end_s = history.TimeAt(history.count - 1),
          .rate_Hz = history.rate_Hz,
          .lead_s = history.posts.lead_s};
}

/// As the study has it done to the channels that a signal is made of, each of which stands for the same share.
void RemoveSlowAsRecorded(const ChannelSource& source, double rate_Hz, Eigen::VectorXd& signal) {
  const auto is_passed = [](const SourceChannel& channel) { return channel.high_pass_Hz.has_value(); };
  if (std::none_of(source.channels.begin(), source.channels.end(), is_passed)) return;
  const double share = 1 / static_cast<double>(source.channels.size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(signal.size());
  for (const SourceChannel& channel : source.channels) {
    Eigen::VectorXd passed = signal;
    if (channel.high_pass_Hz)
      RemoveSlow({passed.data(), static_cast<std::size_t>(passed.size())}, rate_Hz, *channel.high_pass_Hz);
    sum += share * passed;
  }
  signal = sum;
}

/// Samples of the window x signals, of readings, sensors x samples to the end of the window.
Eigen::MatrixXd SignalsOf(const MeasuredHistory& history, const Eigen::MatrixXd& readings) {
  Eigen::MatrixXd out(history.count, static_cast<Index>(history.signals.size()));
  Eigen::VectorXd all(readings.cols());
  for (Index i = 0; i < out.cols(); ++i) {
    all = readings.row(static_cast<Index>(history.signals[static_cast<std::size_t>(i)].sensor));
    if (const auto& filter = history.filter) {
      // Its gain at rest is 1.
      all.array() -= HeldReading(history, history.signals[static_cast<std::size_t>(i)], all[0]);
      LowPass(filter->order, filter->cutoff_Hz, history.rate_Hz)
          .Apply({all.data(), static_cast<std::size_t>(all.size())});
    }
    RemoveSlowAsRecorded(history.signals[static_cast<std::size_t>(i)].source, history.rate_Hz, all);
    out.col(i) = all.tail(history.count);
    out.col(i).array() -= out.col(i).mean();
  }
  return out;
}

/// Of the straight line through the first hundredth of a second [unit/s].
double FirstSlope(const Eigen::VectorXd& values, double rate_Hz) {
  const Index count = std::min(values.size(), std::max<Index>(5, std::lround(0.01 * rate_Hz)));
  const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(count, -1, 1);
  return t.dot(values.head(count)) / t.squaredNorm() * 2 * rate_Hz / static_cast<double>(count - 1);
}

/// What displacement sensors measured at first, above where the record ends at rest, and the pose and velocities
/// nearest to rest that show it; without any the pose at rest.
Eigen::VectorXd GuessStart(const MeasuredHistory& history, const CondensedModel& model) {
  const Release& release = *history.release;
  Eigen::VectorXd guess = Eigen::VectorXd::Zero(release.Unknowns(model));
  const Index last = std::max<Index>(1, history.count / 10);
  const auto reading = [&](const MeasuredSignal& signal) { return signal.values[0] - signal.values.tail(last).mean(); };
  if (release.from == Release::From::kHeld) {
    Index next = 0;
    for (const Release::Hold& hold : release.held) {
      if (hold.reading_m) continue;
      for (const MeasuredSignal& signal : history.signals)
        if (signal.sensor == hold.index) guess[next] = reading(signal);
      ++next;
    }
    return guess;
  }
  std::vector<Index> sensors;
  std::vector<std::array<double, 2>> readings;
  for (const MeasuredSignal& signal : history.signals)
    if (ParseUnit(signal.unit)->dimension == kLength) {
      sensors.push_back(static_cast<Index>(signal.sensor));
      readings.push_back({reading(signal), FirstSlope(signal.values, history.rate_Hz)});
    }
  if (sensors.empty()) return guess;
  const LeastNorm rows(Eigen::MatrixXd(model.on_position(sensors, Eigen::all)), 1e-6);
  const Eigen::Index n = model.mass.rows();
  const Index parts = release.from == Release::From::kRest ? 1 : 2;
  for (Index part = 0; part < parts; ++part) {
    Eigen::VectorXd measured(std::ssize(readings));
    for (Index i = 0; i < measured.size(); ++i)
      measured[i] = readings[static_cast<std::size_t>(i)][static_cast<std::size_t>(part)];
    guess.segment(part * n, n) = rows.Solve(measured);
  }
  // What sticks pulls against the last motion, or away from rest, by half of what it can.
  for (std::size_t i = 0; i < model.rubbings.size(); ++i) {
    const CondensedModel::Rubbing& friction = model.rubbings[i];
    const double along = friction.direction.dot(guess.segment((parts - 1) * n, n));
    guess[parts * n + static_cast<Index>(i)] = std::copysign(0.5 * friction.law.force / friction.law.stiffness, along);
  }
  return guess;
}

}  // namespace

HistorySimulation::HistorySimulation(const MeasuredHistory& history, double step_s)
    : history_(&history),
      parts_(std::max(1L, std::lround(std::ceil(1 / (history.rate_Hz * step_s) - 1e-9)))),
      samples_(SamplesBefore(history) + history.count),
      lead_(history.release ? 0 : SamplesBefore(history) - history.first) {
  const double start = StartOfMotion_s(history);
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
  March(model, StateOf(model, deadline), deadline, sample);
}

template <typename Sample>
void HistorySimulation::March(const CondensedModel& model, const Eigen::VectorXd& state, const Deadline& deadline,
                              const Sample& sample) const {
  March(
      model, state, deadline, [](CondensedStepper&) {}, sample);
}

template <typename Follow, typename Sample>
void HistorySimulation::March(const CondensedModel& model, const Eigen::VectorXd& state, const Deadline& deadline,
                              const Follow& follow, const Sample& sample) const {
  CondensedStepper stepper(model, step_s());
  if (state.size() > 0) stepper.SetState(state, PostsAt(0));
  else stepper.Start(PostsAt(0));
  follow(stepper);
  for (Index k = 0; k < samples_; ++k) {
    if (k % kStepsBetweenChecks == 0) deadline.Check();
    for (long part = 0; part < parts_ && k > 0; ++part) {
      stepper.Step(PostsAt((k - 1) * parts_ + part + 1));
      follow(stepper);
    }
    sample(k, stepper);
    // So written that it is true for NaN.
    if (!(stepper.state().norm() < kFarthest)) throw SimulationError(kMotionUnbounded);
  }
  if (stepper.unsolved_steps() > 0) throw SimulationError(kForcesUnsolved, {std::to_string(stepper.unsolved_steps())});
}

Eigen::MatrixXd HistorySimulation::Run(const CondensedModel& model, const Deadline& deadline) const {
  return Run(model, StateOf(model, deadline), deadline);
}

Eigen::VectorXd HistorySimulation::StateOf(const CondensedModel& model, const Deadline& deadline) const {
  return history_->release ? StartOf(model, deadline).state : Eigen::VectorXd();
}

HistorySimulation::Start HistorySimulation::StartOf(const CondensedModel& model, const Deadline& deadline) const {
  const Release& release = *history_->release;
  const Index count = release.Unknowns(model);
  const Eigen::VectorXd guess = release.guess.size() == count ? release.guess : GuessStart(*history_, model);
  const auto residuals = [&](const Eigen::VectorXd& unknowns) {
    const Eigen::MatrixXd run = Run(model, ReleasedState(release, model, unknowns), deadline);
    const Index stride = history_->Stride();
    const Index rows = (history_->count + stride - 1) / stride;
    Eigen::VectorXd left(rows * run.cols());
    for (Index i = 0; i < run.cols(); ++i) {
      const MeasuredSignal& signal = history_->signals[static_cast<std::size_t>(i)];
      left.segment(i * rows, rows) = (run.col(i) - signal.MeasuredOr(run.col(i)))(Eigen::seqN(0, rows, stride)) /
                                     std::hypot(signal.noise_sd, release.model_error * signal.Deviation());
    }
    return left;
  };
  EstimatedStart estimate = EstimateStart(residuals, guess, release.Reach(model));
  return {.state = ReleasedState(release, model, estimate.unknowns), .estimate = std::move(estimate)};
}

Eigen::MatrixXd HistorySimulation::Run(const CondensedModel& model, const Eigen::VectorXd& state,
                                       const Deadline& deadline) const {
  Eigen::MatrixXd readings(model.on_position.rows(), samples_);
  March(model, state, deadline, [&](Index k, const CondensedStepper& stepper) { stepper.Read(readings.col(k)); });
  Eigen::MatrixXd signals = SignalsOf(*history_, readings);
  if (history_->correction.size() > 0) signals += history_->correction;
  return signals;
}

Eigen::MatrixXd HistorySimulation::RunWithOffset(const CondensedModel& model, const Eigen::VectorXd& offset) const {
  Eigen::MatrixXd readings(model.on_position.rows(), samples_);
  Index steps = 0;
  const auto follow = [&](CondensedStepper& stepper) {
    if (steps == lead_ * parts_) stepper.SetState(stepper.state() + offset, PostsAt(steps));
    ++steps;
  };
  March(model, {}, {}, follow, [&](Index k, const CondensedStepper& stepper) { stepper.Read(readings.col(k)); });
  Eigen::MatrixXd signals = SignalsOf(*history_, readings);
  if (history_->correction.size() > 0) signals += history_->correction;
  return signals;
}

std::vector<Eigen::MatrixXd> HistorySimulation::RunNear(const CondensedModel& model,
                                                        std::span<const CondensedModel> neighbours) const {
  const Index sensors = model.on_position.rows();
  const std::size_t together = std::max<std::size_t>(1, kMostReadings / static_cast<std::size_t>(sensors * samples_));
  std::vector<Eigen::MatrixXd> signals;
  while (signals.size() < neighbours.size()) {
    const auto group = neighbours.subspan(signals.size(), std::min(together, neighbours.size() - signals.size()));
    MotionSensitivity sensitivity(model, group, step_s());
    std::vector<Eigen::MatrixXd> readings(group.size(), Eigen::MatrixXd(sensors, samples_));
    Eigen::VectorXd own(sensors);
    Eigen::MatrixXd changes(sensors, std::ssize(group));
    Index steps = 0;
    const auto follow = [&](CondensedStepper& stepper) {
      if (steps++ == 0) sensitivity.Start(stepper);
      else sensitivity.Step(stepper);
    };
    March(model, {}, {}, follow, [&](Index k, const CondensedStepper& stepper) {
      stepper.Read(own);
      sensitivity.Read(stepper, changes);
      for (std::size_t i = 0; i < group.size(); ++i) readings[i].col(k) = own + changes.col(static_cast<Index>(i));
    });
    for (const Eigen::MatrixXd& one : readings) {
      signals.push_back(SignalsOf(*history_, one));
      if (history_->correction.size() > 0) signals.back() += history_->correction;
    }
  }
  return signals;
}

Eigen::MatrixXd HistorySimulation::Readings(const CondensedModel& model, const Eigen::VectorXd& state) const {
  Eigen::MatrixXd readings(model.on_position.rows(), samples_);
  March(model, state, {}, [&](Index k, const CondensedStepper& stepper) { stepper.Read(readings.col(k)); });
  return readings.rightCols(history_->count).transpose();
}

HistoryMotion HistorySimulation::Motion(const CondensedModel& model, Index stride) const {
  RequireOption(stride >= 1, "HistorySimulation::Motion: stride", static_cast<double>(stride), "at least 1");
  const Index first = samples_ - history_->count;
  const Index frames = (history_->count - 1) / stride + 1;
  HistoryMotion motion{.start_s = history_->TimeAt(0), .rate_Hz = history_->rate_Hz / static_cast<double>(stride)};
  const auto heights = static_cast<Index>(history_->heights.size());
  motion.posts.resize(frames, heights);
  motion.coordinates.resize(frames, model.mass.rows());
  March(model, {}, [&](Index k, const CondensedStepper& stepper) {
    if (k < first || (k - first) % stride != 0) return;
    const Index frame = (k - first) / stride;
    const std::span<const PostState> posts = PostsAt(k * parts_);
    for (Index p = 0; p < heights; ++p) motion.posts(frame, p) = posts[static_cast<std::size_t>(p)].height;
    motion.coordinates.row(frame) = stepper.state().head(model.mass.rows()).transpose();
  });
  return motion;
}

std::optional<EngineHistory> SimulateBy(const HistorySolver::Options& options, const MeasuredHistory& history,
                                        const Vehicle& vehicle, const std::vector<double>& stated,
                                        const HistorySolver::Progress& progress) {
  const std::vector<double> values = history.setting.At(stated);
  Vehicle measured = vehicle;
  measured.sensors.clear();
  MeasuredHistory numbered = history;
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    measured.sensors.push_back(vehicle.sensors[history.signals[i].sensor]);
    numbered.signals[i].sensor = i;
  }
  HistorySolver::Options from = options;
  if (history.release)
    from.released = HistorySimulation(history, kLongestStep_s).StateOf(CondensedVehicle(vehicle).At(values));
  const SolvedHistory solved =
      HistorySolver(measured, values).Solve(history.posts.motion, GridOf(history), from, progress);
  if (solved.ended) return std::nullopt;
  return EngineHistory{
      .modelled = SignalsOf(numbered, solved.history.readings.transpose()), .by = solved.by, .released = from.released};
}

double HistoryStep(const MeasuredHistory& history, const CondensedModel& model, const RigView& rig, double error) {
  CondensedHistoryOptions options{.error = error};
  if (history.release) options.released = HistorySimulation(history, kLongestStep_s).StateOf(model);
  return SimulateCondensed(model, rig, history.posts.motion, GridOf(history), options).step_s;
}

}  // namespace fourpost
