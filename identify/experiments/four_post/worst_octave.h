#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"

namespace fourpost {

/// Where the residuals of a channel's responses are largest: recording and octave, cut at the limits of the fitted
/// band.
struct WorstOctave {
  std::string recording;
  double lower_Hz = 0;
  double upper_Hz = 0;
  /// Their root mean square over noise and stated model error, see ResponseDeviations().
  double misfit = 0;
};

struct FrequencyBand {
  double lower_Hz = 0;
  double upper_Hz = 0;
};

/// The octave with the largest misfit. Octaves begin at whole powers of two; those with fewer than three frequencies
/// count only where no other has more. `runs`: within the band; `modelled`: one response per run. Nothing where no
/// residual is known.
std::optional<WorstOctave> WorstOctaveOf(const std::string& channel, const std::vector<MeasuredRun>& runs,
                                         const std::vector<FrequencyResponse>& modelled, const ModelError& model_error,
                                         const FrequencyBand& band);

}  // namespace fourpost
