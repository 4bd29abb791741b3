#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/frequency_response/dwells.h"
#include "analysis/frequency_response/post_shares.h"
#include "analysis/frequency_response/rig_signals.h"

namespace fourpost {

/// A channel during one dwell, or over several of one frequency.
struct DwellChannel {
  /// Per displacement of the reference.
  std::complex<double> response;
  /// Of that mean, real and imaginary part together; NaN where too few cycles were measured.
  double variance = 0;
  /// In the channel's unit, over the settled cycles.
  double mean = 0;
  /// Of it: by the scatter of cycles, and by what the last change of frequency may have left in it.
  double mean_variance = 0;
  /// Of the straight drift over these cycles, less what noise makes of it.
  double drift_square = 0;
  /// Amplitudes of harmonics 1, 2, ... in the channel's unit.
  std::vector<double> harmonics;

  /// Root of the sum of squares of the others, over the first.
  double Distortion() const;
};

/// What was measured at one frequency.
struct DwellResponse {
  double frequency_Hz = 0;
  /// Of the reference post.
  double amplitude = 0;
  PostShares shares;
  /// Samples that were used, the last one excluded.
  std::size_t first = 0;
  std::size_t last = 0;
  /// Whole cycles in these, and those before them that were left out.
  int cycles = 0;
  int run_in_cycles = 0;
  bool is_settled = true;
  /// Of the reference's motion.
  double post_distortion = 0;
  std::vector<DwellChannel> channels;
};

/// Responses in the dwells of a record: frequency from the reference post, run-in cut by SettledPartOf() of the ratios
/// of channels to posts, then a fit of offset, drift and five harmonics to the whole cycles that are left (FitSines).
/// The response is the ratio of the fundamentals to the motion of the posts' pattern. Its variance is that of the mean
/// of the cycles' differences from it, Y - H X over X, see VarianceOfMean(): noise of posts and channels alike, as far
/// as they are not of one source. Dwells with fewer than three whole settled cycles are left out.
///
/// A mean settles with the slowest mode of the vehicle, whatever the frequency of the posts, and a dwell of ten cycles
/// at 20 Hz lasts half a second. Of a transient A exp(s t) the mean over T seconds is its change over them by s T, so
/// that the drift shows what is left of it in the mean: drift / (2 pi f T), with 0.5 Hz for f, which few vehicles go
/// below. Drifts are those of a dwell and its neighbours in time, as one may turn just then.
std::vector<DwellResponse> RespondInDwells(const RigSignals& signals, std::span<const Dwell> dwells,
                                           std::optional<std::size_t> reference = std::nullopt);

}  // namespace fourpost
