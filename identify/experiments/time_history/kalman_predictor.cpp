#include "identify/experiments/time_history/kalman_predictor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>

#include "analysis/text/option_check.h"
#include "identify/experiments/time_history/findings.h"
#include "vehicles/condensed/port.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/condensed_stepper.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kSamplesBetweenChecks = 100;
/// Differences of states: a micrometre, a micrometre a second.
constexpr double kStep = 1e-6;

/// The stepper as maps of the state alone, and their derivatives.
class Maps {
 public:
  Maps(const CondensedModel& model, const MeasuredHistory& history)
      : stepper_(model, 1 / history.rate_Hz),
        history_(history),
        readings_(stepper_.sensor_count()),
        linear_(HeldPortsOf(model).empty()) {}

  Index states() const { return stepper_.state().size(); }
  /// Whether the slopes are those of any other state: with all tyres on the ground of a vehicle that is linear else.
  bool linear() const { return linear_ && !stepper_.lifts(); }

  VectorXd Start(std::span<const PostState> posts) {
    stepper_.Start(posts);
    return stepper_.state();
  }

  VectorXd Step(const VectorXd& state, std::span<const PostState> from, std::span<const PostState> to) {
    stepper_.SetState(state, from);
    stepper_.Step(to);
    if (stepper_.unsolved_steps() > 0 || !stepper_.state().allFinite()) throw SimulationError(kKalmanMotionUnsolved);
    return stepper_.state();
  }

  VectorXd Read(const VectorXd& state, std::span<const PostState> posts) {
    stepper_.SetState(state, posts);
    stepper_.Read(readings_);
    VectorXd signals(static_cast<Index>(history_.signals.size()));
    for (Index i = 0; i < signals.size(); ++i)
      signals[i] = readings_[static_cast<Index>(history_.signals[static_cast<std::size_t>(i)].sensor)];
    return signals;
  }

  /// Of the step that Step() took last.
  const MatrixXd& StepSlopes(const VectorXd& state, std::span<const PostState> from, std::span<const PostState> to) {
    return Kept(step_slopes_, [&] { return Slopes(state, [&](const VectorXd& x) { return Step(x, from, to); }); });
  }

  /// Of what Read() read last.
  const MatrixXd& ReadSlopes(const VectorXd& state, std::span<const PostState> posts) {
    return Kept(read_slopes_, [&] { return Slopes(state, [&](const VectorXd& x) { return Read(x, posts); }); });
  }

 private:
  template <typename Map>
  static MatrixXd Slopes(const VectorXd& state, const Map& map) {
    const VectorXd here = map(state);
    MatrixXd slopes(here.size(), state.size());
    VectorXd moved = state;
    for (Index j = 0; j < state.size(); ++j) {
      moved[j] += kStep;
      slopes.col(j) = (map(moved) - here) / kStep;
      moved[j] = state[j];
    }
    return slopes;
  }

  /// As they are now, and while the vehicle is linear.
  struct KeptSlopes {
    MatrixXd now;
    MatrixXd linear;
  };

  /// Those of a linear vehicle are found once.
  template <typename Find>
  const MatrixXd& Kept(KeptSlopes& slopes, const Find& find) {
    if (!linear()) return slopes.now = find();
    if (slopes.linear.size() == 0) slopes.linear = find();
    return slopes.linear;
  }

  CondensedStepper stepper_;
  const MeasuredHistory& history_;
  VectorXd readings_;
  /// But for tyres that lift off.
  bool linear_;
  KeptSlopes step_slopes_;
  KeptSlopes read_slopes_;
};

bool HasUnknown(const MeasuredHistory& history) {
  return std::any_of(history.signals.begin(), history.signals.end(),
                     [](const MeasuredSignal& signal) { return !signal.is_unknown.empty(); });
}

/// A sample that was not measured corrects nothing.
void LeaveOutUnknown(const MeasuredSignal& signal, Index i, Index row, VectorXd& innovation, MatrixXd& sensor) {
  constexpr double kUnknown = 1e12;
  if (signal.is_unknown.empty() || !signal.is_unknown[static_cast<std::size_t>(row)]) return;
  innovation[i] = 0;
  sensor(i, i) = kUnknown * signal.values.squaredNorm();
}

}  // namespace

KalmanPredictor::KalmanPredictor(const MeasuredHistory& history)
    : history_(&history), samples_(history.first + history.count) {
  if (history.filter)
    throw std::invalid_argument("a Kalman predictor takes recordings as they are: leave 'filter' out of history '" +
                                history.name + "'");
  posts_.resize(static_cast<std::size_t>(samples_) * history.posts.count);
  for (Index k = 0; k < samples_; ++k)
    history.posts.motion(history.TimeAt(k - history.first),
                         {posts_.data() + static_cast<std::size_t>(k) * history.posts.count, history.posts.count});
}

KalmanPrediction KalmanPredictor::Run(const CondensedModel& model, const KalmanNoise& noise,
                                      const Deadline& deadline) const {
  if (!model.hydraulics.empty())
    throw std::invalid_argument("a Kalman predictor knows nothing of the oil in hydraulic dampers");
  if (!model.rubbings.empty())
    throw std::invalid_argument("a Kalman predictor knows nothing of the force of friction that sticks");
  const auto signals = static_cast<Index>(history_->signals.size());
  const Index coordinates = model.mass.rows();
  RequireOption(noise.process_sd.size() == coordinates && noise.process_sd.minCoeff() > 0,
                "KalmanPredictor: process_sd", noise.process_sd.size() > 0 ? noise.process_sd.minCoeff() : 0.0,
                "above 0, one per coordinate");
  RequireOption(noise.sensor_sd.size() == signals && noise.sensor_sd.minCoeff() > 0, "KalmanPredictor: sensor_sd",
                noise.sensor_sd.size() > 0 ? noise.sensor_sd.minCoeff() : 0.0, "above 0, one per signal");
  const auto posts_at = [&](Index k) {
    return std::span(posts_.data() + static_cast<std::size_t>(k) * history_->posts.count, history_->posts.count);
  };
  Maps maps(model, *history_);
  // Offsets: those of the model left to itself.
  MatrixXd simulated(history_->count, signals);
  VectorXd state = maps.Start(posts_at(0));
  for (Index k = 0; k < samples_; ++k) {
    if (k > 0) state = maps.Step(state, posts_at(k - 1), posts_at(k));
    if (k >= history_->first) simulated.row(k - history_->first) = maps.Read(state, posts_at(k));
  }
  const Eigen::RowVectorXd offset = simulated.colwise().mean();

  const Index n = maps.states();
  // A force that is constant over a sample moves the coordinate by half of the velocity it gives times the sample.
  MatrixXd process = MatrixXd::Zero(n, n);
  const double h = 1 / history_->rate_Hz;
  for (Index i = 0; i < coordinates; ++i) {
    VectorXd push = VectorXd::Zero(n);
    push[i] = 0.5 * h * h * noise.process_sd[i];
    push[coordinates + i] = h * noise.process_sd[i];
    process += push * push.transpose();
  }
  const MatrixXd known_sensor = noise.sensor_sd.array().square().matrix().asDiagonal();
  MatrixXd sensor = known_sensor;
  const bool has_unknown = HasUnknown(*history_);

  KalmanPrediction out{.predicted = MatrixXd(history_->count, signals),
                       .innovations = MatrixXd(history_->count, signals),
                       .whitened = MatrixXd(history_->count, signals)};
  state = maps.Start(posts_at(0));
  MatrixXd covariance = process;
  for (Index k = 0; k < samples_; ++k) {
    if (k % kSamplesBetweenChecks == 0) deadline.Check();
    if (k > 0) {
      VectorXd next = maps.Step(state, posts_at(k - 1), posts_at(k));
      const MatrixXd& step = maps.StepSlopes(state, posts_at(k - 1), posts_at(k));
      covariance = step * covariance * step.transpose() + process;
      state = std::move(next);
    }
    if (k < history_->first) continue;
    const Index row = k - history_->first;
    out.predicted.row(row) = maps.Read(state, posts_at(k));
    const MatrixXd& read = maps.ReadSlopes(state, posts_at(k));
    VectorXd innovation(signals);
    for (Index i = 0; i < signals; ++i)
      innovation[i] = history_->signals[static_cast<std::size_t>(i)].values[row] + offset[i];
    innovation -= out.predicted.row(row).transpose();
    out.predicted.row(row) -= offset;
    if (has_unknown) sensor = known_sensor;
    for (Index i = 0; has_unknown && i < signals; ++i)
      LeaveOutUnknown(history_->signals[static_cast<std::size_t>(i)], i, row, innovation, sensor);
    const MatrixXd spread = read * covariance * read.transpose() + sensor;
    const Eigen::LLT<MatrixXd> root(spread);
    const VectorXd whitened = root.matrixL().solve(innovation);
    out.innovations.row(row) = innovation;
    out.whitened.row(row) = whitened;
    out.log_determinant += 2 * root.matrixLLT().diagonal().array().log().sum();
    const MatrixXd gain = root.solve(read * covariance).transpose();
    state += gain * innovation;
    const MatrixXd kept = MatrixXd::Identity(n, n) - gain * read;
    covariance = kept * covariance * kept.transpose() + gain * sensor * gain.transpose();
  }
  if (!std::isfinite(out.Deviance())) throw SimulationError(kKalmanCovariance);
  return out;
}

std::vector<double*> KalmanPredictor::Unknown(KalmanNoise& noise) const {
  std::vector<double*> unknown;
  if (history_->process_sd == 0)
    for (double& sd : noise.process_sd) unknown.push_back(&sd);
  for (Index i = 0; i < noise.sensor_sd.size(); ++i)
    if (history_->signals[static_cast<std::size_t>(i)].noise_sd == 0) unknown.push_back(&noise.sensor_sd[i]);
  return unknown;
}

KalmanNoise KalmanPredictor::Estimate(const CondensedModel& model, const NoiseSearch& search) const {
  KalmanNoise noise;
  noise.process_sd = VectorXd::Constant(model.mass.rows(), history_->process_sd > 0 ? history_->process_sd : 0.1);
  noise.sensor_sd.resize(static_cast<Index>(history_->signals.size()));
  for (Index i = 0; i < noise.sensor_sd.size(); ++i) {
    const MeasuredSignal& signal = history_->signals[static_cast<std::size_t>(i)];
    noise.sensor_sd[i] = signal.noise_sd > 0 ? signal.noise_sd : 0.02 * signal.Deviation();
  }
  if (Unknown(noise).empty()) return noise;
  int runs = 0;
  const auto deviance_now = [&] {
    const double deviance = Run(model, noise, Deadline::In(search.deadline_s)).Deviance();
    if (search.progress) search.progress(++runs);
    return deviance;
  };
  double least = deviance_now();
  for (const double factor : {10.0, 3.0, 1.5}) {
    bool better = true;
    for (int round = 0; round < 3 && better; ++round) {
      better = false;
      for (double* sd : Unknown(noise))
        for (const double change : {factor, 1 / factor}) {
          const double before = *sd;
          *sd *= change;
          const double deviance = deviance_now();
          if (deviance < least) {
            least = deviance;
            better = true;
            break;
          }
          *sd = before;
        }
    }
  }
  return noise;
}

}  // namespace fourpost
