#include "identify/history_residuals.h"

#include <cmath>
#include <span>
#include <utility>

#include <Eigen/QR>

#include "analysis/fit_quality.h"
#include "analysis/option_check.h"

namespace fourpost {
namespace {

using Eigen::Index;

Index Strided(Index count, Index stride) { return (count + stride - 1) / stride; }

std::span<const double> Span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Least squares of measured = gain modelled - gain delay modelled'; exact for delays short against a period, and
/// repeated from the shifted model for others.
void FitGainAndDelay(const Eigen::VectorXd& measured, const Eigen::VectorXd& modelled, double rate_Hz,
                     HistoryMisfit& misfit) {
  const Index inner = measured.size() - 2;
  Eigen::MatrixX2d columns(inner, 2);
  columns.col(0) = modelled.segment(1, inner);
  columns.col(1) = 0.5 * rate_Hz * (modelled.tail(inner) - modelled.head(inner));
  const Eigen::Vector2d solution = columns.colPivHouseholderQr().solve(measured.segment(1, inner));
  misfit.gain = solution[0];
  misfit.delay_s = -solution[1] / solution[0];
}

}  // namespace

HistoryResiduals::HistoryResiduals(const Vehicle& vehicle, std::vector<MeasuredHistory> histories,
                                   const Options& options)
    : condensed_(vehicle), histories_(std::move(histories)), options_(options) {
  RequireOption(options.model_error >= 0 && std::isfinite(options.model_error), "HistoryResiduals: model_error",
                options.model_error, "finite and not negative");
  const CondensedModel model = condensed_.At(vehicle.ParameterValues());
  const RigView rig = RigViewOf(vehicle);
  simulations_.reserve(histories_.size());
  for (const MeasuredHistory& history : histories_) {
    simulations_.emplace_back(history, HistoryStep(history, model, rig, options.error));
    const Index each =
        options.cost == HistoryCost::kCompromise ? history.count : Strided(history.count, history.Stride());
    count_ += each * static_cast<Index>(history.signals.size());
  }
}

Eigen::VectorXd HistoryResiduals::At(const std::vector<double>& values, const Deadline& deadline) const {
  const CondensedModel model = condensed_.At(values);
  Eigen::VectorXd residuals(count_);
  Index at = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const Eigen::MatrixXd modelled = simulations_[h].Run(model, deadline);
    const Index each =
        options_.cost == HistoryCost::kCompromise ? history.count : Strided(history.count, history.Stride());
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
  const CondensedModel model = condensed_.At(values);
  std::vector<Eigen::MatrixXd> modelled;
  for (const HistorySimulation& simulation : simulations_) modelled.push_back(simulation.Run(model));
  return modelled;
}

std::vector<double> HistoryResiduals::Steps() const {
  std::vector<double> steps;
  for (const HistorySimulation& simulation : simulations_) steps.push_back(simulation.step_s());
  return steps;
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
                           .unit = signal.unit,
                           .nmse_percent = NormalisedMse_percent(Span(signal.values), Span(model)),
                           .vaf_percent = VarianceAccountedFor_percent(Span(signal.values), Span(model))};
      FitGainAndDelay(signal.values, model, histories[h].rate_Hz, misfit);
      misfits.push_back(std::move(misfit));
    }
  return misfits;
}

}  // namespace fourpost
