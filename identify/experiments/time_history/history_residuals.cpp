#include "identify/experiments/time_history/history_residuals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "analysis/text/option_check.h"
#include "identify/experiments/time_history/start_state.h"
#include "identify/residuals/calibrated_sensor.h"
#include "identify/residuals/sensor_group.h"
#include "vehicles/condensed/model_change.h"
#include "vehicles/simulation/motion_sensitivity.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// What a sensor takes of a motion across its axis, of the loudest of its unit: data sheets of accelerometers state
/// less.
constexpr double kCrossAxis = 0.02;

Index Strided(Index count, Index stride) { return (count + stride - 1) / stride; }

double LogDeterminantOf(const std::vector<KalmanPrediction>& predictions) {
  double sum = 0;
  for (const KalmanPrediction& prediction : predictions) sum += prediction.log_determinant;
  return sum;
}

}  // namespace

HistoryResiduals::HistoryResiduals(std::shared_ptr<const CondensedVehicle> vehicle,
                                   std::vector<MeasuredHistory> histories, const Options& options)
    : condensed_(std::move(vehicle)), histories_(std::move(histories)), options_(options) {
  RequireOption(options.model_error >= 0 && std::isfinite(options.model_error), "HistoryResiduals: model_error",
                options.model_error, "finite and not negative");
  const std::vector<double> of_file = condensed_->vehicle().ParameterValues();
  const RigView rig = RigViewOf(condensed_->vehicle());
  simulations_.reserve(histories_.size());
  for (MeasuredHistory& history : histories_) {
    const CondensedModel model = ModelOf(history, of_file);
    if (history.release) history.release->model_error = options.model_error;
    const double step_s = options.steps_s.empty() ? HistoryStep(history, model, rig, options.error)
                                                  : options.steps_s.at(simulations_.size());
    simulations_.emplace_back(history, step_s);
    // Estimates go on from that at the file's values, the same in every thread.
    if (history.release) history.release->guess = simulations_.back().StartOf(model).estimate.unknowns;
    if (options.cost == HistoryCost::kPrediction) predictors_.emplace_back(history);
    count_ += CountOf(history) * static_cast<Index>(history.signals.size());
  }
  if (options.cost != HistoryCost::kPrediction) return;
  noise_ = options.noise;
  if (noise_.empty())
    for (std::size_t h = 0; h < predictors_.size(); ++h)
      noise_.push_back(predictors_[h].Estimate(ModelOf(histories_[h], of_file), options.noise_search));
  RequireOption(noise_.size() == histories_.size(), "HistoryResiduals: noise", static_cast<double>(noise_.size()),
                "one per history");
  reference_log_determinant_ = LogDeterminantOf(Predicted(of_file));
}

CondensedModel HistoryResiduals::ModelOf(const MeasuredHistory& history, const std::vector<double>& values) const {
  return condensed_->At(history.setting.At(values));
}

Index HistoryResiduals::CountOf(const MeasuredHistory& history) const {
  return options_.cost == HistoryCost::kWhitened ? Strided(history.count, history.Stride()) : history.count;
}

Eigen::VectorXd HistoryResiduals::At(const std::vector<double>& values, const Deadline& deadline) const {
  if (options_.cost == HistoryCost::kPrediction) return OfPrediction(Predicted(values, deadline));
  Eigen::VectorXd residuals(count_);
  Index at = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h)
    AddHistory(histories_[h], Modelled(h, ModelOf(histories_[h], values), deadline), at, residuals);
  return residuals;
}

Eigen::VectorXd HistoryResiduals::AtFinerSteps(const std::vector<double>& values) const {
  Eigen::VectorXd residuals(count_);
  Index at = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const CondensedModel model = ModelOf(history, values);
    Eigen::MatrixXd modelled = HistorySimulation(history, 0.25 * simulations_[h].step_s()).Run(model);
    AddStartTo(history, model, modelled);
    AddHistory(history, modelled, at, residuals);
  }
  return residuals;
}

void HistoryResiduals::AddHistory(const MeasuredHistory& history, const Eigen::MatrixXd& modelled, Index& at,
                                  Eigen::VectorXd& out) const {
  const Index each = CountOf(history);
  for (std::size_t i = 0; i < history.signals.size(); ++i, at += each)
    AddSignal(history, history.signals[i], modelled.col(static_cast<Index>(i)), out.segment(at, each));
}

Eigen::VectorXd HistoryResiduals::OfPrediction(const std::vector<KalmanPrediction>& predictions) const {
  const auto count = static_cast<double>(count_);
  const double scale = std::exp((LogDeterminantOf(predictions) - reference_log_determinant_) / (2 * count));
  Eigen::VectorXd residuals(count_);
  Index at = 0;
  for (const KalmanPrediction& prediction : predictions) {
    residuals.segment(at, prediction.whitened.size()) = scale * prediction.whitened.reshaped();
    at += prediction.whitened.size();
  }
  return residuals;
}

void HistoryResiduals::AddSignal(const MeasuredHistory& history, const MeasuredSignal& signal,
                                 const Eigen::VectorXd& modelled, Eigen::Ref<Eigen::VectorXd> out) const {
  const double deviation = signal.Deviation();
  const Eigen::VectorXd measured = signal.MeasuredOr(modelled);
  if (options_.cost == HistoryCost::kCompromise) {
    out = 10 / (std::sqrt(static_cast<double>(history.count)) * deviation) * (modelled - measured);
    out *= out.norm();
    return;
  }
  const double sd = DeviationOf(signal);
  const Index stride = history.Stride();
  for (Index k = 0; k < out.size(); ++k) out[k] = (modelled[k * stride] - measured[k * stride]) / sd;
}

std::vector<Eigen::MatrixXd> HistoryResiduals::Modelled(const std::vector<double>& values) const {
  std::vector<Eigen::MatrixXd> modelled;
  for (std::size_t h = 0; h < simulations_.size(); ++h)
    modelled.push_back(Modelled(h, ModelOf(histories_[h], values), {}));
  return modelled;
}

Eigen::MatrixXd HistoryResiduals::Modelled(std::size_t h, const CondensedModel& model, const Deadline& deadline) const {
  const MeasuredHistory& history = histories_[h];
  Eigen::MatrixXd modelled = simulations_[h].Run(model, deadline);
  if (options_.cost == HistoryCost::kWhitened) AddStartTo(history, model, modelled);
  return modelled;
}

Eigen::VectorXd HistoryResiduals::ResidualsOf(const MeasuredHistory& history, const CondensedModel& model,
                                              Eigen::MatrixXd modelled) const {
  if (options_.cost == HistoryCost::kWhitened) AddStartTo(history, model, modelled);
  Eigen::VectorXd residuals(CountOf(history) * modelled.cols());
  Index at = 0;
  AddHistory(history, modelled, at, residuals);
  return residuals;
}

bool HistoryResiduals::HasDerivatives() const {
  const auto is_released = [](const MeasuredHistory& history) { return history.release.has_value(); };
  return options_.cost != HistoryCost::kPrediction && std::none_of(histories_.begin(), histories_.end(), is_released);
}

Eigen::MatrixXd HistoryResiduals::Derivatives(const std::vector<double>& values,
                                              const std::vector<std::size_t>& parameters) const {
  std::vector<std::vector<double>> neighbours;
  for (const std::size_t parameter : parameters) neighbours.push_back(NeighbourOf(values, parameter));
  const auto model_of = [&](std::size_t i, const MeasuredHistory& history) { return ModelOf(history, neighbours[i]); };
  Eigen::MatrixXd derivatives = Changes(values, parameters.size(), model_of, Uncovered::kIntegrated);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    derivatives.col(static_cast<Index>(i)) /= neighbours[i][parameters[i]] - values[parameters[i]];
  return derivatives;
}

Eigen::MatrixXd HistoryResiduals::Toward(const std::vector<double>& values,
                                         std::span<const OtherVehicle> others) const {
  const auto model_of = [&](std::size_t i, const MeasuredHistory& history) {
    return others[i].vehicle->At(history.setting.At(others[i].values));
  };
  return Changes(values, others.size(), model_of, Uncovered::kLeftOut);
}

Eigen::MatrixXd HistoryResiduals::Changes(
    const std::vector<double>& values, std::size_t count,
    const std::function<CondensedModel(std::size_t, const MeasuredHistory&)>& model_of, Uncovered uncovered) const {
  Eigen::MatrixXd changes(count_, static_cast<Index>(count));
  Index first = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const CondensedModel model = ModelOf(history, values);
    const Eigen::VectorXd here = ResidualsOf(history, model, simulations_[h].Run(model));
    const auto set = [&](std::size_t i, const CondensedModel& other, Eigen::MatrixXd modelled) {
      changes.col(static_cast<Index>(i)).segment(first, here.size()) =
          ResidualsOf(history, other, std::move(modelled)) - here;
    };
    std::vector<CondensedModel> covered;
    std::vector<std::size_t> their_columns;
    for (std::size_t i = 0; i < count; ++i) {
      CondensedModel other = model_of(i, history);
      if (MotionSensitivity::Covers(model, other)) {
        covered.push_back(std::move(other));
        their_columns.push_back(i);
      } else if (uncovered == Uncovered::kIntegrated) {
        set(i, other, simulations_[h].Run(other));
      } else {
        changes.col(static_cast<Index>(i)).setConstant(std::numeric_limits<double>::quiet_NaN());
      }
    }
    std::vector<Eigen::MatrixXd> near = simulations_[h].RunNear(model, covered);
    for (std::size_t c = 0; c < covered.size(); ++c) set(their_columns[c], covered[c], std::move(near[c]));
    first += here.size();
  }
  return changes;
}

std::vector<double> HistoryResiduals::NeighbourOf(std::vector<double> values, std::size_t parameter) const {
  values[parameter] += DifferenceOf(condensed_->vehicle().parameters[parameter], values[parameter]);
  return values;
}

namespace {

/// Posts that moved `share` more, or earlier by `delay_s`, than recorded; actuators as they are.
MeasuredHistory WithPosts(const MeasuredHistory& history, double share, double delay_s) {
  MeasuredHistory other = history;
  other.posts.motion = [motion = history.posts.motion, count = history.heights.size(), share, delay_s](
                           double t, std::span<PostState> posts) {
    motion(t + delay_s, posts);
    for (PostState& post : posts.first(std::min(count, posts.size()))) {
      post.height *= 1 + share;
      post.velocity *= 1 + share;
      post.acceleration *= 1 + share;
    }
  };
  return other;
}

/// Per second, by differences of neighbours.
Eigen::VectorXd SlopeOf(const Eigen::VectorXd& values, double rate_Hz) {
  const Index n = values.size();
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(n);
  if (n < 3) return slope;
  slope.segment(1, n - 2) = 0.5 * rate_Hz * (values.tail(n - 2) - values.head(n - 2));
  slope[0] = slope[1];
  slope[n - 1] = slope[n - 2];
  return slope;
}

}  // namespace

Eigen::MatrixXd HistoryResiduals::Calibrated(std::size_t h, const CondensedModel& model, const Calibration& calibration,
                                             const Eigen::MatrixXd& modelled) const {
  const MeasuredHistory& history = histories_[h];
  const bool is_gain = calibration.kind == Calibration::Kind::kGain;
  if (calibration.IsOfPosts()) {
    const MeasuredHistory other = WithPosts(history, is_gain ? calibration.sd : 0, is_gain ? 0 : calibration.sd);
    return HistorySimulation(other, simulations_[h].step_s()).Run(model);
  }
  Eigen::MatrixXd calibrated = modelled;
  for (std::size_t s = 0; s < history.signals.size(); ++s) {
    if (!IsOf(calibration, condensed_->vehicle(), history.signals[s].sensor)) continue;
    auto signal = calibrated.col(static_cast<Index>(s));
    if (is_gain) signal *= 1 + calibration.sd;
    else signal -= calibration.sd * SlopeOf(signal, history.rate_Hz);
  }
  return calibrated;
}

Eigen::MatrixXd HistoryResiduals::ByCalibrations(const std::vector<Calibration>& calibrations,
                                                 const std::vector<double>& values) const {
  Eigen::MatrixXd changes(count_, std::ssize(calibrations));
  Index first = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const CondensedModel model = ModelOf(history, values);
    Eigen::MatrixXd modelled = simulations_[h].Run(model);
    // Instruments read the free motion as well.
    AddStartTo(history, model, modelled);
    const Eigen::VectorXd here = ResidualsOf(history, model, modelled);
    for (std::size_t c = 0; c < calibrations.size(); ++c)
      changes.col(static_cast<Index>(c)).segment(first, here.size()) =
          ResidualsOf(history, model, Calibrated(h, model, calibrations[c], modelled)) - here;
    first += here.size();
  }
  return changes;
}

double HistoryResiduals::DeviationOf(const MeasuredSignal& signal) const {
  return std::hypot(signal.noise_sd, options_.model_error * std::max(signal.Deviation(), kCrossAxis * signal.loudest));
}

std::vector<KalmanPrediction> HistoryResiduals::Predicted(const std::vector<double>& values,
                                                          const Deadline& deadline) const {
  std::vector<KalmanPrediction> predicted;
  for (std::size_t h = 0; h < predictors_.size(); ++h)
    predicted.push_back(predictors_[h].Run(ModelOf(histories_[h], values), noise_[h], deadline));
  return predicted;
}

std::vector<double> HistoryResiduals::Steps() const {
  std::vector<double> steps;
  for (const HistorySimulation& simulation : simulations_) steps.push_back(simulation.step_s());
  return steps;
}

std::vector<PostNoise> HistoryResiduals::PostNoiseAt(const std::vector<double>& values) const {
  std::vector<PostNoise> noise;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const CondensedModel model = ModelOf(histories_[h], values);
    noise.push_back(PostNoiseOf(histories_[h], model, Modelled(h, model, {}), simulations_[h].step_s()));
  }
  return noise;
}

std::vector<Eigen::VectorXd> HistoryResiduals::ByPostNoise(const std::vector<double>& values) const {
  const std::vector<PostNoise> noise = PostNoiseAt(values);
  std::vector<Eigen::VectorXd> sizes;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    sizes.emplace_back(Eigen::VectorXd::Zero(std::ssize(history.signals)));
    if (!noise[h].IsAny()) continue;
    const CondensedModel model = ModelOf(history, values);
    const auto residuals = [&](double sign) {
      const MeasuredHistory noisy = WithPostNoise(history, noise[h], h, sign);
      return ResidualsOf(history, model, HistorySimulation(noisy, simulations_[h].step_s()).Run(model));
    };
    // Half the difference of both, in which all that the noise did not change cancels.
    const Eigen::VectorXd change = 0.5 * (residuals(1) - residuals(-1));
    const Index each = CountOf(history);
    for (Index i = 0; i < sizes[h].size(); ++i) {
      const Index measured = each - history.signals[static_cast<std::size_t>(i)].UnknownCount(history.Stride());
      sizes[h][i] = std::sqrt(change.segment(i * each, each).squaredNorm() / static_cast<double>(measured));
    }
  }
  return sizes;
}

std::vector<double> HistoryResiduals::ChangesByHalfStep(const std::vector<double>& values) const {
  std::vector<double> changes;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const CondensedModel model = ModelOf(histories_[h], values);
    const Eigen::MatrixXd coarse = simulations_[h].Run(model);
    const Eigen::MatrixXd fine = HistorySimulation(histories_[h], 0.5 * simulations_[h].step_s()).Run(model);
    changes.push_back(((coarse - fine).colwise().norm().array() / fine.colwise().norm().array()).maxCoeff());
  }
  return changes;
}

ResidualStructure HistoryResiduals::Structure() const {
  ResidualPartition groups = {"sensor groups", {}, {}};
  ResidualStructure structure;
  Index at = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const Index each = CountOf(history);
    const Index stride = options_.cost == HistoryCost::kWhitened ? history.Stride() : 1;
    for (const MeasuredSignal& signal : history.signals) {
      groups.Add(SensorGroup(condensed_->vehicle(), signal.sensor), each);
      structure.recordings.Add(history.name, each);
      structure.series.push_back({.first = at,
                                  .count = each,
                                  .step = 1,
                                  .is_over_time = true,
                                  .record = static_cast<int>(h),
                                  .start_s = history.TimeAt(0),
                                  .interval_s = static_cast<double>(stride) / history.rate_Hz,
                                  .unmeasured = signal.UnknownCount(stride)});
      at += each;
    }
  }
  structure.partitions = {std::move(groups)};
  if (options_.cost == HistoryCost::kWhitened) structure.absorbed = Starts();
  return structure;
}

}  // namespace fourpost
