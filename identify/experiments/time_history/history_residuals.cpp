#include "identify/experiments/time_history/history_residuals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/signals/autocorrelation.h"
#include "analysis/signals/fit_quality.h"
#include "analysis/signals/signal_timing.h"
#include "analysis/text/option_check.h"
#include "identify/experiments/time_history/start_state.h"
#include "identify/residuals/calibrated_sensor.h"
#include "identify/residuals/sensor_group.h"
#include "vehicles/condensed/model_change.h"
#include "vehicles/simulation/motion_sensitivity.h"

namespace fourpost {
namespace {

using Eigen::Index;

Index Strided(Index count, Index stride) { return (count + stride - 1) / stride; }

double LogDeterminantOf(const std::vector<KalmanPrediction>& predictions) {
  double sum = 0;
  for (const KalmanPrediction& prediction : predictions) sum += prediction.log_determinant;
  return sum;
}

std::span<const double> Span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
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
    simulations_.emplace_back(history, HistoryStep(history, model, rig, options.error));
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
  if (options_.cost == HistoryCost::kCompromise) {
    out = 10 / (std::sqrt(static_cast<double>(history.count)) * deviation) * (modelled - signal.values);
    out *= out.norm();
    return;
  }
  const double sd = DeviationOf(signal);
  const Index stride = history.Stride();
  for (Index k = 0; k < out.size(); ++k) out[k] = (modelled[k * stride] - signal.values[k * stride]) / sd;
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

void HistoryResiduals::AddStartTo(const MeasuredHistory& history, const CondensedModel& model,
                                  Eigen::MatrixXd& modelled) const {
  Eigen::VectorXd weights(modelled.cols());
  for (Index i = 0; i < weights.size(); ++i)
    weights[i] = 1 / std::pow(DeviationOf(history.signals[static_cast<std::size_t>(i)]), 2);
  if (!history.release) AddStart(history, model, weights, history.Stride(), modelled);
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
  Eigen::MatrixXd derivatives(count_, std::ssize(parameters));
  Index first = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const CondensedModel model = ModelOf(history, values);
    const Eigen::VectorXd here = ResidualsOf(history, model, simulations_[h].Run(model));
    std::vector<CondensedModel> covered;
    std::vector<std::size_t> their_columns;
    const auto differentiate = [&](std::size_t i, const CondensedModel& neighbour, Eigen::MatrixXd modelled) {
      const double difference = NeighbourOf(values, parameters[i])[parameters[i]] - values[parameters[i]];
      derivatives.col(static_cast<Index>(i)).segment(first, here.size()) =
          (ResidualsOf(history, neighbour, std::move(modelled)) - here) / difference;
    };
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      CondensedModel neighbour = ModelOf(history, NeighbourOf(values, parameters[i]));
      if (MotionSensitivity::Covers(model, neighbour)) {
        covered.push_back(std::move(neighbour));
        their_columns.push_back(i);
      } else {
        differentiate(i, neighbour, simulations_[h].Run(neighbour));
      }
    }
    std::vector<Eigen::MatrixXd> near = simulations_[h].RunNear(model, covered);
    for (std::size_t c = 0; c < covered.size(); ++c) differentiate(their_columns[c], covered[c], std::move(near[c]));
    first += here.size();
  }
  return derivatives;
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
  return std::hypot(signal.noise_sd, options_.model_error * signal.Deviation());
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

namespace {

/// Nothing known of it is taken for noise that may be there.
bool MayHavePostNoise(const std::vector<MeasuredHistory>& histories) {
  for (const MeasuredHistory& history : histories)
    for (std::size_t p = 0; p < history.post_noise_sd.size(); ++p)
      if (history.post_noise_sd[p] > 0 || !history.post_noise_is_stated[p]) return true;
  return false;
}

/// See ResidualBlock::with_input_noise.
std::vector<ResidualBlock> WithPostNoise(const HistoryResiduals& residuals,
                                         const std::shared_ptr<const CondensedVehicle>& vehicle,
                                         const std::vector<Calibration>& calibrations,
                                         const std::vector<double>& values) {
  const std::vector<PostNoise> noise = residuals.PostNoiseAt(values);
  if (std::none_of(noise.begin(), noise.end(), [](const PostNoise& one) { return one.IsAny(); })) return {};
  std::vector<ResidualBlock> both;
  for (const double sign : {-1.0, 1.0}) {
    std::vector<MeasuredHistory> noisy;
    for (std::size_t h = 0; h < noise.size(); ++h)
      noisy.push_back(WithPostNoise(residuals.histories()[h], noise[h], h, sign));
    both.push_back(HistoryBlock(vehicle, std::move(noisy), residuals.options(), calibrations));
  }
  return both;
}

}  // namespace

Eigen::MatrixXd HistoryResiduals::Starts() const {
  std::vector<Eigen::MatrixXd> motions;
  Index columns = 0;
  for (const MeasuredHistory& history : histories_) {
    const CondensedModel model = ModelOf(history, condensed_->vehicle().ParameterValues());
    motions.push_back(history.release ? Eigen::MatrixXd(0, 0) : FreeMotions(history, model));
    columns += motions.back().cols();
  }
  Eigen::MatrixXd starts = Eigen::MatrixXd::Zero(count_, columns);
  Index row = 0;
  Index column = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const Index each = CountOf(history);
    for (std::size_t s = 0; s < history.signals.size(); ++s, row += each) {
      if (motions[h].cols() == 0) continue;
      const auto rows = Eigen::seqN(static_cast<Index>(s) * history.count, each, history.Stride());
      starts.block(row, column, each, motions[h].cols()) =
          motions[h](rows, Eigen::all) / DeviationOf(history.signals[s]);
    }
    column += motions[h].cols();
  }
  return starts;
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
                                  .interval_s = static_cast<double>(stride) / history.rate_Hz});
      at += each;
    }
  }
  structure.partitions = {std::move(groups)};
  if (options_.cost == HistoryCost::kWhitened) structure.absorbed = Starts();
  return structure;
}

ResidualBlock HistoryBlock(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredHistory> histories,
                           const HistoryResiduals::Options& options, const std::vector<Calibration>& calibrations) {
  const bool has_noise = options.cost == HistoryCost::kWhitened && MayHavePostNoise(histories);
  const auto residuals = std::make_shared<const HistoryResiduals>(vehicle, std::move(histories), options);
  std::function<Eigen::VectorXd(const std::vector<double>&)> at_finer_steps;
  if (options.cost == HistoryCost::kWhitened)
    at_finer_steps = [residuals](const std::vector<double>& values) { return residuals->AtFinerSteps(values); };
  std::function<std::vector<ResidualBlock>(const std::vector<double>&)> with_input_noise;
  if (has_noise)
    with_input_noise = [=](const std::vector<double>& values) {
      return WithPostNoise(*residuals, vehicle, calibrations, values);
    };
  std::function<Eigen::MatrixXd(const std::vector<double>&)> by_calibrations;
  if (options.cost == HistoryCost::kWhitened && !calibrations.empty())
    by_calibrations = [residuals, calibrations](const std::vector<double>& values) {
      return residuals->ByCalibrations(calibrations, values);
    };
  decltype(ResidualBlock::differentiate) differentiate;
  if (residuals->HasDerivatives())
    differentiate = [residuals](const std::vector<double>& values, const std::vector<std::size_t>& parameters) {
      return residuals->Derivatives(values, parameters);
    };
  return {.name = "time histories",
          .count = residuals->count(),
          // What the elements' forces are solved to, times what a step's error may grow to.
          .accuracy = 1e-9,
          .evaluate =
              [residuals](const std::vector<double>& values, const Deadline& deadline) {
                try {
                  return Evaluation{.residuals = residuals->At(values, deadline)};
                } catch (const std::runtime_error& fault) {
                  return Failed(Failure::kNotConverged, fault.what());
                }
              },
          .differentiate = std::move(differentiate),
          .at_finer_steps = std::move(at_finer_steps),
          .by_calibrations = std::move(by_calibrations),
          .structure = residuals->Structure(),
          .with_input_noise = std::move(with_input_noise)};
}

void AddOneStepErrors(const std::vector<MeasuredHistory>& histories, const std::vector<KalmanPrediction>& predictions,
                      std::vector<HistoryMisfit>& misfits) {
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (std::size_t i = 0; i < histories[h].signals.size(); ++i, ++misfit) {
      const Eigen::VectorXd predicted = predictions[h].predicted.col(static_cast<Index>(i));
      misfit->one_step_nmse_percent = NormalisedMse_percent(Span(histories[h].signals[i].values), Span(predicted));
      const Whiteness whiteness = WhitenessOf(predictions[h].innovations.col(static_cast<Index>(i)));
      misfit->innovation_correlation = whiteness.next;
      misfit->innovations_beyond = whiteness.beyond;
    }
}

void AddReducedErrors(const MeasuredHistory& history, const Eigen::MatrixXd& modelled,
                      std::span<HistoryMisfit> misfits) {
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    const Eigen::VectorXd signal = modelled.col(static_cast<Index>(i));
    misfits[i].reduced_nmse_percent = NormalisedMse_percent(Span(history.signals[i].values), Span(signal));
  }
}

namespace {

/// Of two signals that each fit the model of the other far better than their own.
void FindSwapped(const MeasuredHistory& history, const Eigen::MatrixXd& modelled, std::span<HistoryMisfit> misfits) {
  // A swap leaves what the model misses; a model that is only poor leaves much of it either way.
  constexpr double kMuchNearer = 0.25;
  const auto error = [&](std::size_t measured, std::size_t model) {
    const Eigen::VectorXd signal = modelled.col(static_cast<Index>(model));
    return NormalisedMse_percent(Span(history.signals[measured].values), Span(signal));
  };
  for (std::size_t i = 0; i < misfits.size(); ++i)
    for (std::size_t j = i + 1; j < misfits.size(); ++j) {
      if (history.signals[i].unit != history.signals[j].unit) continue;
      if (!(error(i, j) < kMuchNearer * misfits[i].nmse_percent && error(j, i) < kMuchNearer * misfits[j].nmse_percent))
        continue;
      misfits[i].swapped_with = misfits[j].name;
      misfits[j].swapped_with = misfits[i].name;
    }
}

}  // namespace

std::vector<HistoryMisfit> HistoryMisfits(const std::vector<MeasuredHistory>& histories,
                                          const std::vector<Eigen::MatrixXd>& modelled) {
  std::vector<HistoryMisfit> misfits;
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const std::size_t first = misfits.size();
    for (std::size_t i = 0; i < histories[h].signals.size(); ++i) {
      const MeasuredSignal& signal = histories[h].signals[i];
      const Eigen::VectorXd model = modelled[h].col(static_cast<Index>(i));
      HistoryMisfit misfit{.recording = histories[h].name,
                           .name = signal.name,
                           .nmse_percent = NormalisedMse_percent(Span(signal.values), Span(model)),
                           .vaf_percent = VarianceAccountedFor_percent(Span(signal.values), Span(model)),
                           .measured_squares = std::pow(signal.Deviation(), 2) * static_cast<double>(model.size()),
                           .unit = signal.unit,
                           .source = signal.source};
      const SignalTiming timing = TimingOf(signal.values, model, histories[h].rate_Hz);
      misfit.gain = timing.gain;
      misfit.delay_s = timing.delay_s;
      misfit.timed_nmse_percent = timing.nmse_percent;
      const Eigen::VectorXd residual = signal.values - model;
      const Index stride = histories[h].Stride();
      JudgeNoise(residual(Eigen::seqN(0, Strided(residual.size(), stride), stride)), misfit);
      misfits.push_back(std::move(misfit));
    }
    FindSwapped(histories[h], modelled[h], std::span(misfits).subspan(first));
  }
  return misfits;
}

std::vector<YardstickRecord> YardstickRecords(const std::vector<MeasuredHistory>& histories) {
  std::vector<YardstickRecord> records;
  for (const MeasuredHistory& history : histories) {
    YardstickRecord record{.name = history.name, .rate_Hz = history.rate_Hz, .setting = history.setting};
    std::vector<std::vector<double>> inputs = history.heights;
    inputs.insert(inputs.end(), history.tensions.begin(), history.tensions.end());
    record.inputs.resize(history.count, static_cast<Index>(inputs.size()));
    for (std::size_t p = 0; p < inputs.size(); ++p)
      record.inputs.col(static_cast<Index>(p)) =
          Eigen::Map<const Eigen::VectorXd>(inputs[p].data() + history.first, history.count);
    for (const MeasuredSignal& signal : history.signals) record.channels.push_back({signal.name, signal.values});
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace fourpost
