#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/frequency_response/stepped_sine.h"
#include "analysis/measured_response/measured_response.h"

namespace fourpost {

/// One recording, read and looked at.
struct LookedAt {
  std::filesystem::path file;
  RigRecording recording;
  std::size_t largest_post = 0;
  std::vector<TonePoint> track = {};
  std::vector<Dwell> dwells = {};
  ExcitationKind kind = ExcitationKind::kStepped;
};

/// What recordings of any kind are measured with, and what is made of them.
struct ResponseWork {
  const ResponseRequest& request;
  Diagnostics& diagnostics;
  MeasuredResponses out = {};
  /// Post that others are relative to.
  std::optional<std::size_t> reference = {};
  /// Of the channels that all recordings have.
  std::vector<std::string> names = {};
  std::vector<std::string> units = {};

  void Fault(const Finding& finding, const std::filesystem::path& file, const std::vector<std::string>& words = {});
  /// What the request's filter leaves of a sine, at least what noise allows to be undone.
  double Passed(double frequency_Hz) const;
  /// A response without a frequency yet, its channels named.
  MeasuredResponse Blank(const PostShares& shares) const;
  /// Names it beside those that there are.
  std::string NameFor(const MeasuredResponse& response) const;
  /// Warns where posts move otherwise than the pattern.
  void CheckPosts(double rest, const MeasuredResponse& response);
};

/// A response per displacement of the reference, as FrequencyResponse has it, with its deviations by the variance of
/// the response as measured.
void AddResponse(std::complex<double> response, double variance, double frequency_Hz, ChannelResponse& channel);

/// With the deviation of its responses; all else is not known, NaN.
ChannelQuality QualityOf(const ChannelResponse& channel);

/// The median over frequencies; NaN without one.
double MedianDeviation(const ChannelResponse& channel);

}  // namespace fourpost
