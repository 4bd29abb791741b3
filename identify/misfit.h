#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/frequency_response.h"
#include "identify/channel_source.h"
#include "identify/four_post_data.h"
#include "identify/kinematics_check.h"
#include "identify/left_out_recording.h"
#include "identify/model_criteria.h"
#include "vehicles/engine/history_solver.h"

namespace fourpost {

/// Difference of model and measurement of one channel, root mean square over frequencies and recordings.
struct ChannelMisfit {
  std::string name;
  double rms_dB = 0;
  double rms_deg = 0;
  /// Squared differences of the complex responses over the squares of those measured: next to a node, where decibels
  /// and degrees jump, it stays small.
  double nmse_percent = 0;
};

/// Of a channel of a time recording.
struct HistoryMisfit {
  std::string recording;
  std::string name;
  /// 100/(N var) sum of squared errors, var: the variance of the measured channel (thesis eq. 3.9); and the share of
  /// that variance that the model accounts for, 100 (1 - var(error)/var).
  double nmse_percent = 0;
  double vaf_percent = 0;
  /// Of a vehicle's: the least-squares answer of measured(t) = gain modelled(t - delay). A gain below zero is a wrong
  /// sign.
  std::optional<double> gain = {};
  std::optional<double> delay_s = {};
  /// What the error would be with these.
  std::optional<double> timed_nmse_percent = {};
  /// Of a Kalman filter that is corrected after each sample and predicts the next: always less than that of a
  /// simulation, also of a poor model. And the correlation of its errors from one sample to the next, 0 if they are
  /// white.
  std::optional<double> one_step_nmse_percent = {};
  std::optional<double> innovation_correlation = {};
  /// Of their first 25 autocorrelations, the share beyond what 95 % of those of white noise keep to: 0.05 if white.
  std::optional<double> innovations_beyond = {};
  /// Of the reduced model, where the full geometry answered.
  std::optional<double> reduced_nmse_percent = {};
  /// The channel of the same unit that this one is measured like, while that one is measured like this: swapped.
  std::optional<std::string> swapped_with = {};
  /// Sum of squares of the measured channel about its mean.
  double measured_squares = 0;
  /// SI; empty of a damper on its bench.
  std::string unit = {};
  /// What the study takes it from.
  ChannelSource source = {};
};

/// A channel of one recording: squares of the errors and of what was measured, whose sums over several make an error in
/// percent of all.
struct ErrorShare {
  std::string channel;
  std::string recording;
  /// Only what is alike here adds up: gains of one unit, or signals of one.
  std::string kind;
  std::string unit;
  /// Of amplitudes over frequency, which pass nodes where small errors are large shares.
  bool has_nodes = false;
  double error = 0;
  double measured = 0;
};

/// The engine that modelled a history, and the integration's error it was asked for.
struct ModelledHistory {
  std::string recording;
  bool is_fitted = true;
  HistoryEngine by;
  double error = 0;
};

/// How far a fitted vehicle is from all the data of its study.
struct Misfits {
  std::vector<ChannelMisfit> responses;
  /// Of each recording of a stepped sine, see RecordingMisfits.
  std::vector<ChannelMisfit> recordings;
  std::vector<HistoryMisfit> histories;
  /// Of recordings that the fit has not seen.
  std::vector<HistoryMisfit> validation;
  /// Of those that were kept for it, the ones that could not be used or predicted.
  std::vector<LeftOutRecording> left_out;
  /// Of all that was fitted but static loads.
  std::vector<ErrorShare> shares;
  /// By what each history was modelled, those of the fit, then those that it has not seen.
  std::vector<ModelledHistory> modelled_by;
  /// Of recordings of stepped sines, which the reduced model answers.
  std::vector<RunKinematics> kinematics;
  /// Of a damper on a bench: of each recording, by which share of its rms the integration errs.
  std::vector<std::pair<std::string, double>> integration;
  /// Of a damper on a bench.
  std::optional<ModelCriteria> criteria;
  /// Modelled load of each tyre of the vehicle at rest [N]; empty where it was not needed.
  std::vector<double> tyre_loads;
};

/// `modelled`: one response per run, at its frequencies, one channel per sensor of the vehicle; frequencies without an
/// answer (NaN) are left out.
std::vector<ChannelMisfit> ResponseMisfits(const std::vector<MeasuredRun>& runs,
                                           const std::vector<FrequencyResponse>& modelled);

/// Of each recording over all its channels, by its name: root mean squares of dB and degrees; the error in percent is
/// the mean over units of squared differences over the squares measured, summed over the channels of a unit, so that a
/// channel next to a node does not drown the others. Arguments as of ResponseMisfits.
std::vector<ChannelMisfit> RecordingMisfits(const std::vector<MeasuredRun>& runs,
                                            const std::vector<FrequencyResponse>& modelled);

/// One per run and channel; arguments as of ResponseMisfits.
std::vector<ErrorShare> ErrorShares(const std::vector<MeasuredRun>& runs,
                                    const std::vector<FrequencyResponse>& modelled);

/// One per recording and channel.
std::vector<ErrorShare> ErrorShares(const std::vector<HistoryMisfit>& misfits);

/// Root mean square over channels whose names begin with `prefix`, of the errors in percent their mean; all of them for
/// an empty one.
ChannelMisfit GroupMisfit(const std::vector<ChannelMisfit>& channels, const std::string& prefix);

}  // namespace fourpost
