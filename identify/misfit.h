#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/frequency_response.h"
#include "identify/channel_source.h"
#include "identify/four_post_data.h"
#include "identify/model_criteria.h"

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
  /// By the full multibody system in place of the condensed one.
  std::optional<double> full_nmse_percent = {};
  /// The channel of the same unit that this one is measured like, while that one is measured like this: swapped.
  std::optional<std::string> swapped_with = {};
  /// SI; empty of a damper on its bench.
  std::string unit = {};
  /// What the study takes it from.
  ChannelSource source = {};
};

/// How far a fitted vehicle is from all the data of its study.
struct Misfits {
  std::vector<ChannelMisfit> responses;
  /// Of each recording of a stepped sine, see RecordingMisfits.
  std::vector<ChannelMisfit> recordings;
  std::vector<HistoryMisfit> histories;
  /// Of recordings that the fit has not seen.
  std::vector<HistoryMisfit> validation;
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

/// Root mean square over channels whose names begin with `prefix`, of the errors in percent their mean; all of them for
/// an empty one.
ChannelMisfit GroupMisfit(const std::vector<ChannelMisfit>& channels, const std::string& prefix);

}  // namespace fourpost
