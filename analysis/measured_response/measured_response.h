#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/frequency_response/excitation_kind.h"
#include "analysis/frequency_response/post_shares.h"
#include "analysis/measured_response/rig_recording.h"
#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A Butterworth low-pass that all channels, posts too, have passed.
struct AcquisitionFilter {
  int order = 4;
  double cutoff_Hz = 0;
};

/// Time histories of which frequency responses are to be made.
struct ResponseRequest {
  /// Of one kind and with the same channels.
  std::vector<std::filesystem::path> files = {};
  /// Empty: by the names of channels, see PostsByName().
  std::vector<PostChannel> posts = {};
  /// Name of the post that others are relative to; empty: the first that moves most.
  std::string reference = {};
  /// Empty: found in the posts' motion.
  std::optional<ExcitationKind> kind = {};
  std::optional<AcquisitionFilter> filter = {};
  RigPreparation preparation = {};
  /// Of sweeps and random motions, rising; empty: 64 over the band in which the posts move. Of stepped sines those of
  /// the dwells; empty: found.
  std::vector<double> frequencies_Hz = {};
};

/// What is known about one channel beside its response.
struct ChannelQuality {
  std::string name;
  /// Stepped sines: the largest ratio of harmonics to the fundamental, and where; multisines: of odd and even lines
  /// that are not excited to those that are. NaN where it is not known.
  double distortion = 0;
  double distortion_Hz = 0;
  /// The lowest, and where; NaN for stepped sines.
  double coherence = 0;
  double coherence_Hz = 0;
  /// Multisines: noise of one period, as a share of the excited lines; else NaN.
  double noise = 0;
  /// Standard deviation over gain, the median over frequencies.
  double deviation = 0;
  /// Sweeps and random motions, at each frequency; else empty.
  std::vector<double> coherence_at = {};
};

/// The response to one pattern of the posts and, of stepped sines, one amplitude at each frequency.
struct MeasuredResponse {
  /// "heave", "posts"; "heave_2" of the second amplitude at its frequencies.
  std::string name;
  PostShares shares;
  /// See PatternOf().
  std::optional<std::string> pattern;
  /// Deviations are those of the mean over repeats. Means are relative to rest, over the repeats of recordings that
  /// begin at rest; empty where a frequency has none.
  FrequencyResponse response;
  /// Stepped sines: dwells at each frequency.
  std::vector<int> repeats = {};
  std::vector<ChannelQuality> channels = {};
};

struct MeasuredResponses {
  ExcitationKind kind = ExcitationKind::kStepped;
  std::vector<std::string> posts;
  /// Of the first file.
  std::vector<std::string> post_channels;
  double rate_Hz = 0;
  double duration_s = 0;
  /// Stepped sines.
  int dwells = 0;
  int unsettled = 0;
  double median_cycles = 0;
  /// Whether a response has them; and of recordings that do not begin at rest, and have none, by how much posts move.
  bool has_means = false;
  std::vector<std::string> without_rest = {};
  /// Sweeps and random motions: least and greatest number of independent averages.
  double least_averages = 0;
  double most_averages = 0;
  /// Multisines.
  double period_s = 0;
  int periods = 0;
  std::vector<MeasuredResponse> responses;
  /// Columns that are no response of a vehicle; and those of them whose unit is not known, as "'oil' (foo)".
  std::vector<std::string> left_out;
  std::vector<std::string> unit_unknown;
  /// Stepped sines: motions without a dwell, which are left out, a sentence each.
  std::vector<std::string> missed = {};
  /// What was done to the time histories before responses were made of them, a sentence each.
  std::vector<std::string> preparations = {};
  /// Channels that move as the posts do at every frequency, up to their sign.
  std::vector<std::string> like_posts;
  /// Of each of these the name that a post beside the others would have and that it nearly has, as 'post_RR' of
  /// 'psot_RR'; empty: none.
  std::vector<std::string> nearly_posts = {};
};

/// "stepped sine", "sweep", "random motion", "multisine"
std::string KindInWords(ExcitationKind kind);

/// Reads time histories and makes frequency responses of them. Adds every fault of the files, and warnings about what
/// was measured, to `diagnostics`; nothing where there is an error.
std::optional<MeasuredResponses> MeasureResponses(const ResponseRequest& request, Diagnostics& diagnostics);

}  // namespace fourpost
