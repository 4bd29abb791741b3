#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analysis/measured_response/measured_response.h"

namespace fourpost {

// What is written and printed of frequency responses that were made of time histories.

/// The recording that 'recordings' of a study takes, see ReadFrequencyResponse().
std::string RecordingCsv(const FrequencyResponse& response);

/// The same as a universal file, per displacement of the reference post: accelerations in m/s^2 per m. It has neither
/// deviations, nor amplitudes of posts, nor mean offsets.
std::string RecordingUniversal(const MeasuredResponse& response, const std::string& reference);

/// Gain and phase with bands of two standard deviations, a row for each channel; the coherence, where there is one.
std::string MeasuredSvg(const MeasuredResponse& response, ExcitationKind kind);

/// Part of a study that fits to these recordings, to be pasted: 'recordings', 'channels' and 'band'.
std::string StudySection(const MeasuredResponses& measured);

/// For the terminal: what was found, and a table of channels for each response.
std::string MeasuredText(const MeasuredResponses& measured);

/// Gains are H1; those of sweeps and random motions also H2 and Hv, the geometric mean of both, which have the phase of
/// H1: noise of the posts lowers H1, noise of a channel raises H2.
nlohmann::ordered_json MeasuredJson(const MeasuredResponses& measured);

}  // namespace fourpost
