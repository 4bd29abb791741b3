#include "identify/history_residuals.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/fit_quality.h"
#include "analysis/option_check.h"
#include "analysis/signal_timing.h"

namespace fourpost {
namespace {

using Eigen::Index;

Index Strided(Index count, Index stride) { return (count + stride - 1) / stride; }

std::span<const double> Span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

HistoryResiduals::HistoryResiduals(std::shared_ptr<const CondensedVehicle> vehicle,
                                   std::vector<MeasuredHistory> histories, const Options& options)
    : condensed_(std::move(vehicle)), histories_(std::move(histories)), options_(options) {
  RequireOption(options.model_error >= 0 && std::isfinite(options.model_error), "HistoryResiduals: model_error",
                options.model_error, "finite and not negative");
  const CondensedModel model = condensed_->At(condensed_->vehicle().ParameterValues());
  const RigView rig = RigViewOf(condensed_->vehicle());
  simulations_.reserve(histories_.size());
  for (const MeasuredHistory& history : histories_) {
    simulations_.emplace_back(history, HistoryStep(history, model, rig, options.error));
    if (options.cost == HistoryCost::kPrediction) {
      predictors_.emplace_back(history);
      noise_.push_back(predictors_.back().Estimate(model));
    }
    count_ += CountOf(history) * static_cast<Index>(history.signals.size());
  }
}

Index HistoryResiduals::CountOf(const MeasuredHistory& history) const {
  return options_.cost == HistoryCost::kWhitened ? Strided(history.count, history.Stride()) : history.count;
}

Eigen::VectorXd HistoryResiduals::At(const std::vector<double>& values, const Deadline& deadline) const {
  const CondensedModel model = condensed_->At(values);
  Eigen::VectorXd residuals(count_);
  Index at = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const Index each = CountOf(history);
    if (options_.cost == HistoryCost::kPrediction) {
      const Eigen::MatrixXd whitened = predictors_[h].Run(model, noise_[h], deadline).whitened;
      residuals.segment(at, whitened.size()) = whitened.reshaped();
      at += whitened.size();
      continue;
    }
    const Eigen::MatrixXd modelled = simulations_[h].Run(model, deadline);
    for (std::size_t i = 0; i < history.signals.size(); ++i, at += each)
      AddSignal(history, history.signals[i], modelled.col(static_cast<Index>(i)), residuals.segment(at, each));
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
  const double sd = std::hypot(signal.noise_sd, options_.model_error * deviation);
  const Index stride = history.Stride();
  for (Index k = 0; k < out.size(); ++k) out[k] = (modelled[k * stride] - signal.values[k * stride]) / sd;
}

std::vector<Eigen::MatrixXd> HistoryResiduals::Modelled(const std::vector<double>& values) const {
  const CondensedModel model = condensed_->At(values);
  std::vector<Eigen::MatrixXd> modelled;
  for (const HistorySimulation& simulation : simulations_) modelled.push_back(simulation.Run(model));
  return modelled;
}

std::vector<KalmanPrediction> HistoryResiduals::Predicted(const std::vector<double>& values,
                                                          const Deadline& deadline) const {
  const CondensedModel model = condensed_->At(values);
  std::vector<KalmanPrediction> predicted;
  for (std::size_t h = 0; h < predictors_.size(); ++h)
    predicted.push_back(predictors_[h].Run(model, noise_[h], deadline));
  return predicted;
}

std::vector<double> HistoryResiduals::Steps() const {
  std::vector<double> steps;
  for (const HistorySimulation& simulation : simulations_) steps.push_back(simulation.step_s());
  return steps;
}

ResidualBlock HistoryBlock(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredHistory> histories,
                           const HistoryResiduals::Options& options) {
  const auto residuals = std::make_shared<const HistoryResiduals>(std::move(vehicle), std::move(histories), options);
  return {.name = "time histories",
          .count = residuals->count(),
          // What the elements' forces are solved to, times what a step's error may grow to.
          .accuracy = 1e-9,
          .evaluate = [residuals](const std::vector<double>& values, const Deadline& deadline) {
            try {
              return Evaluation{.residuals = residuals->At(values, deadline)};
            } catch (const std::runtime_error& fault) {
              return Failed(Failure::kNotConverged, fault.what());
            }
          }};
}

void AddOneStepErrors(const std::vector<MeasuredHistory>& histories, const std::vector<KalmanPrediction>& predictions,
                      std::vector<HistoryMisfit>& misfits) {
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (std::size_t i = 0; i < histories[h].signals.size(); ++i, ++misfit) {
      const Eigen::VectorXd predicted = predictions[h].predicted.col(static_cast<Index>(i));
      misfit->one_step_nmse_percent = NormalisedMse_percent(Span(histories[h].signals[i].values), Span(predicted));
      misfit->innovation_correlation = WhitenessOf(predictions[h].innovations.col(static_cast<Index>(i))).next;
    }
}

std::vector<HistoryMisfit> HistoryMisfits(const std::vector<MeasuredHistory>& histories,
                                          const std::vector<Eigen::MatrixXd>& modelled) {
  std::vector<HistoryMisfit> misfits;
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (std::size_t i = 0; i < histories[h].signals.size(); ++i) {
      const MeasuredSignal& signal = histories[h].signals[i];
      const Eigen::VectorXd model = modelled[h].col(static_cast<Index>(i));
      HistoryMisfit misfit{.recording = histories[h].name,
                           .name = signal.name,
                           .nmse_percent = NormalisedMse_percent(Span(signal.values), Span(model)),
                           .vaf_percent = VarianceAccountedFor_percent(Span(signal.values), Span(model))};
      const SignalTiming timing = TimingOf(signal.values, model, histories[h].rate_Hz);
      misfit.gain = timing.gain;
      misfit.delay_s = timing.delay_s;
      misfit.timed_nmse_percent = timing.nmse_percent;
      misfits.push_back(std::move(misfit));
    }
  return misfits;
}

}  // namespace fourpost
