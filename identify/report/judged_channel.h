#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// How well a model follows a channel: by its residuals over noise and stated model error, as the verdict on the whole
/// fit, up to 1.5 well and above 3 not, but roughly where model and measurement look alike all the same. Of runs and
/// costs without them by decibels and degrees, or by NMSE.
enum class Follows { kWell, kRoughly, kNot };

/// Where a channel's residuals are largest: a recording of stepped sines and an octave, cut at the fitted band.
struct WorstPlace {
  std::string recording;
  double lower_Hz = 0;
  double upper_Hz = 0;
  /// Of the residuals there.
  double misfit = 0;
};

/// A channel of a result.json, by its misfit.
struct JudgedChannel {
  std::string name;
  /// Of a channel over time.
  std::string recording;
  std::string numbers;
  /// Residuals over noise and stated model error; NaN where the run does not hold it.
  double misfit = std::numeric_limits<double>::quiet_NaN();
  Follows follows = Follows::kWell;
  /// Above 1 where it is not followed well.
  double score = 0;
  bool is_history = false;
  /// Of stepped sines; runs of older versions hold none.
  std::optional<WorstPlace> worst = {};
};

/// Best first: by how they are followed, of those alike by their score. Where all have one name, such as a damper's
/// force, their recordings tell them apart; where all are of one recording, their names do.
std::vector<JudgedChannel> JudgeChannels(const std::vector<nlohmann::json>& channels);

/// What a channel that is followed stays within, of the kinds of channels there are.
std::string ShownLimits(const std::vector<JudgedChannel>& channels);

}  // namespace fourpost
