#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"

namespace fourpost {

/// The responses of a recording of a study: of a table of stepped sines as it stands, see ReadFrequencyResponse(); of a
/// time history as MeasureResponses() makes them, those in which the posts of the vehicle move as stated: `posts` are
/// their names, `shape` their shares. Where `posts` is empty, whatever the file holds. Adds every fault, at the study's
/// line where it contradicts the file; nothing when there was one.
std::optional<FrequencyResponse> ReadStudyRecording(const StudyRecording& recording, const std::string& study,
                                                    const std::vector<std::string>& posts,
                                                    const std::vector<double>& shape, Diagnostics& diagnostics);

}  // namespace fourpost
