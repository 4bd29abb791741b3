#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/diagnostics.h>
#include <fourpost/study.h>

namespace fourpost::api {

struct FrfOptions {
  /// Channel of the displacement of each post, by the post's name; empty: channels named post_FL, FL and the
  /// like, or with words that mean a post.
  std::map<std::string, std::string> posts = {};
  /// Post that responses are relative to; empty: the first that moves most.
  std::string reference = {};
  /// "stepped", "sweep", "random" or "multisine"; empty: found in the posts' motion.
  std::string kind = {};
  /// The Butterworth low-pass that all channels have passed, posts too.
  std::optional<LowPass> filter = {};
  /// Of sweeps and random motions, rising; empty: 64 in the band of the posts.
  std::vector<double> frequency_Hz = {};
  /// Files of other recorders, and by how much their clocks are ahead [s].
  std::vector<std::pair<std::filesystem::path, double>> beside = {};
  /// Where the recordings are written that a study takes, as `fourpost frf -o`; empty: nowhere.
  std::filesystem::path output = {};
};

/// A channel, one value per frequency; empty where it is not known.
struct MeasuredChannel {
  std::string name;
  /// "m", "N", "m/s^2" or "rad/s".
  std::string unit;
  /// As ChannelResponse::frf.
  Eigen::VectorXcd frf;
  /// Standard deviations of its gain, in its unit, and of its phase.
  Eigen::VectorXd gain_sd;
  Eigen::VectorXd phase_sd_rad;
  /// As in ChannelResponse.
  Eigen::VectorXd mean;
  /// Standard deviation of the mean, in the channel's unit.
  Eigen::VectorXd mean_sd;
  Eigen::VectorXd second_harmonic;
  /// Of sweeps and random motions.
  Eigen::VectorXd coherence;
};

/// The responses to one pattern of the posts and, of stepped sines, one amplitude at each frequency.
struct MeasuredPattern {
  /// "heave", "posts"; "heave_2" of the second amplitude at its frequencies.
  std::string name;
  /// As SteppedSine::posts.
  std::string posts;
  std::string reference;
  /// Share of the posts' motion that is not of this pattern.
  double off_pattern = 0;
  std::vector<double> frequency_Hz;
  /// Of the reference post.
  std::vector<double> amplitude_m;
  /// Stepped sines: dwells at each frequency.
  std::vector<int> repeats;
  std::vector<MeasuredChannel> channels;
};

/// Frequency responses that were made of time histories.
struct FrfMeasurement {
  /// "stepped", "sweep", "random" or "multisine".
  std::string kind;
  double rate_Hz = 0;
  double duration_s = 0;
  std::vector<MeasuredPattern> patterns;
  /// Columns that are no response of a vehicle.
  std::vector<std::string> left_out;
  /// frf.json, the tables that `fourpost frf` prints, and the part of a study that takes the recordings.
  std::string json;
  std::string text;
  std::string study_section;
  std::vector<Finding> warnings;
};

/// Frequency responses of time histories of one motion: stepped sines, sweeps, random motions or multisines. Throws
/// Error.
FrfMeasurement MeasureFrf(const std::vector<std::filesystem::path>& files, const FrfOptions& options = {});

}  // namespace fourpost::api
