#pragma once

#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/four_post/response_misfit.h"

namespace fourpost {

/// Measurement (dots) and model (line) as an SVG document: one row of panels for each of `channels`, titled with its
/// misfit; one column each for gain [dB] and phase [deg] of every run, over frequency [Hz] on a logarithmic scale.
/// Frequencies outside lower_Hz..upper_Hz are shaded. Phases go from -180 to 180; one near an edge is drawn at both.
///
/// `modelled`: one response per run, at its frequencies, one channel per sensor of the vehicle. A gain of zero, and a
/// run that has not the channel, leave a gap. Throws std::invalid_argument without a run.
std::string ResponseSvg(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                        const std::vector<ChannelMisfit>& channels, double lower_Hz, double upper_Hz);

}  // namespace fourpost
