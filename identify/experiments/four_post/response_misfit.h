#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/four_post/worst_octave.h"
#include "identify/residuals/error_share.h"

namespace fourpost {

/// Difference of model and measurement of one channel, root mean square over frequencies and recordings.
struct ChannelMisfit {
  std::string name;
  double rms_dB = 0;
  double rms_deg = 0;
  /// Squared differences of the complex responses over the squares of those measured: next to a node, where decibels
  /// and degrees jump, it stays small.
  double nmse_percent = 0;
  /// Without physics, of the same squares: those of the stated standard deviations, where there are any; and what a
  /// response that is one for all recordings of a pattern leaves, their mean at frequencies that they share.
  std::optional<double> scatter_percent = {};
  std::optional<double> linear_percent = {};
  /// Of relative differences of the complex responses at neighbouring frequencies; about 0 where noise is all there is.
  double residual_correlation = 0;
  /// Residuals over noise and stated model error, see ResponseDeviations(), over all recordings.
  std::optional<double> misfit = {};
  /// Where that is largest.
  std::optional<WorstOctave> worst = {};

  /// The least error that either shows to be possible: more is the model's.
  std::optional<double> Allowed_percent() const;
};

/// `modelled`: one response per run, at its frequencies, one channel per sensor of the vehicle; frequencies without an
/// answer (NaN) are left out.
std::vector<ChannelMisfit> ResponseMisfits(const std::vector<MeasuredRun>& runs,
                                           const std::vector<FrequencyResponse>& modelled);

/// Adds ChannelMisfit::misfit. Arguments as of ResponseMisfits.
void AddDeviations(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                   const ModelError& model_error, std::vector<ChannelMisfit>& misfits);

/// Of each recording over all its channels, by its name: root mean squares of dB and degrees; the error in percent is
/// the mean over units of squared differences over the squares measured, summed over the channels of a unit, so that a
/// channel next to a node does not drown the others. Arguments as of ResponseMisfits.
std::vector<ChannelMisfit> RecordingMisfits(const std::vector<MeasuredRun>& runs,
                                            const std::vector<FrequencyResponse>& modelled);

/// One per run and channel; arguments as of ResponseMisfits.
std::vector<ErrorShare> ErrorShares(const std::vector<MeasuredRun>& runs,
                                    const std::vector<FrequencyResponse>& modelled);

/// Root mean square over channels whose names begin with `prefix`, of the errors in percent their mean; all of them for
/// an empty one.
ChannelMisfit GroupMisfit(const std::vector<ChannelMisfit>& channels, const std::string& prefix);

}  // namespace fourpost
