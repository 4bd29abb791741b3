#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analysis/measured_response/measured_response.h"

namespace fourpost {

// What is written and printed of frequency responses that were made of time histories.

/// The recording that 'recordings' of a study takes, see ReadFrequencyResponse().
std::string RecordingCsv(const FrequencyResponse& response);

/// Gain and phase with bands of two standard deviations, a row for each channel; the coherence, where there is one.
std::string MeasuredSvg(const MeasuredResponse& response, ExcitationKind kind);

/// Part of a study that fits to these recordings, to be pasted: 'recordings', 'channels' and 'band'.
std::string StudySection(const MeasuredResponses& measured);

/// For the terminal: what was found, and a table of channels for each response.
std::string MeasuredText(const MeasuredResponses& measured);

nlohmann::ordered_json MeasuredJson(const MeasuredResponses& measured);

}  // namespace fourpost
