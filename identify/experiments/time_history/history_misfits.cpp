#include "identify/experiments/time_history/history_misfits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/signals/autocorrelation.h"
#include "analysis/signals/fit_quality.h"
#include "analysis/signals/signal_timing.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

using Eigen::Index;

std::span<const double> Span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

void AddOneStepErrors(const std::vector<MeasuredHistory>& histories, const std::vector<KalmanPrediction>& predictions,
                      std::vector<HistoryMisfit>& misfits) {
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (std::size_t i = 0; i < histories[h].signals.size(); ++i, ++misfit) {
      const Eigen::VectorXd predicted = predictions[h].predicted.col(static_cast<Index>(i));
      const Eigen::VectorXd measured = histories[h].signals[i].MeasuredOr(predicted);
      misfit->one_step_nmse_percent = NormalisedMse_percent(Span(measured), Span(predicted));
      const Whiteness whiteness = WhitenessOf(predictions[h].innovations.col(static_cast<Index>(i)));
      misfit->innovation_correlation = whiteness.next;
      misfit->innovations_beyond = whiteness.beyond;
    }
}

void AddReducedErrors(const MeasuredHistory& history, const Eigen::MatrixXd& modelled,
                      std::span<HistoryMisfit> misfits) {
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    const Eigen::VectorXd signal = modelled.col(static_cast<Index>(i));
    const Eigen::VectorXd measured = history.signals[i].MeasuredOr(signal);
    misfits[i].reduced_nmse_percent = NormalisedMse_percent(Span(measured), Span(signal));
  }
}

namespace {

/// Of two signals that each fit the model of the other far better than their own.
void FindSwapped(const MeasuredHistory& history, const Eigen::MatrixXd& modelled, std::span<HistoryMisfit> misfits) {
  // A swap leaves what the model misses; a model that is only poor leaves much of it either way.
  constexpr double kMuchNearer = 0.25;
  const auto error = [&](std::size_t measured, std::size_t model) {
    const Eigen::VectorXd signal = modelled.col(static_cast<Index>(model));
    const Eigen::VectorXd values = history.signals[measured].MeasuredOr(signal);
    return NormalisedMse_percent(Span(values), Span(signal));
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

HistoryMisfit::Drive DriveOf(const MeasuredHistory& history) {
  if (!history.release && !history.HasMovingActuator()) return HistoryMisfit::Drive::kPosts;
  return history.HasMovingActuator() || history.HasMovingPost() ? HistoryMisfit::Drive::kSeveral
                                                                : HistoryMisfit::Drive::kRelease;
}

double FirstAboveLast(const Eigen::VectorXd& values) {
  return values[0] - values.tail(std::max<Index>(1, values.size() / 10)).mean();
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
      const Eigen::VectorXd measured = signal.MeasuredOr(model);
      HistoryMisfit misfit{.recording = histories[h].name,
                           .name = signal.name,
                           .nmse_percent = NormalisedMse_percent(Span(measured), Span(model)),
                           .vaf_percent = VarianceAccountedFor_percent(Span(measured), Span(model)),
                           .measured_squares = std::pow(signal.Deviation(), 2) * static_cast<double>(model.size()),
                           .unit = signal.unit,
                           .source = signal.source,
                           .drive = DriveOf(histories[h])};
      const SignalTiming timing = TimingOf(measured, model, histories[h].rate_Hz);
      misfit.gain = timing.gain;
      misfit.delay_s = timing.delay_s;
      misfit.timed_nmse_percent = timing.nmse_percent;
      if (misfit.drive == HistoryMisfit::Drive::kRelease && ParseUnit(signal.unit)->dimension == kLength)
        misfit.released_from_m = std::copysign(1, timing.gain) * FirstAboveLast(measured);
      const Eigen::VectorXd residual = measured - model;
      const Index stride = histories[h].Stride();
      JudgeNoise(residual(Eigen::seqN(0, (residual.size() + stride - 1) / stride, stride)), misfit);
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
    const MeasuredHistory::Stretch part = history.LongestMeasured();
    record.inputs.resize(part.count, static_cast<Index>(inputs.size()));
    for (std::size_t p = 0; p < inputs.size(); ++p)
      record.inputs.col(static_cast<Index>(p)) =
          Eigen::Map<const Eigen::VectorXd>(inputs[p].data() + history.first + part.first, part.count);
    for (const MeasuredSignal& signal : history.signals)
      record.channels.push_back({signal.name, WithoutMean(signal.values.segment(part.first, part.count))});
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace fourpost
