#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/four_post/four_post_data.h"

namespace fourpost {

/// Whether a file is a time history, of which responses are made.
bool IsOverTime(const StudyRecording& recording);
/// The column of times of one of `like` that a file has too, whatever it is called; nothing where there is none.
std::optional<SourceChannel> TimesAsIn(const std::vector<StudyRecording>& like, const RecordedTable& table);

/// Sensor of the vehicle, and what was measured for it. Unit, offset and drift of channels are taken out of time
/// histories before responses are made of them; sign, scale and delay are left to the user of these.
using StudyChannels = std::vector<std::pair<std::string, ChannelSource>>;

/// What is in a time history: its channels, and how the posts of the vehicle moved, the share of each in each motion.
struct HistoryContent {
  std::vector<std::string> channels;
  std::vector<std::vector<double>> shapes;
};

/// Of a recording that is a time history, whose posts the study need not state. Adds every fault; nothing when there
/// was one.
std::optional<HistoryContent> ReadHistoryContent(const StudyRecording& recording, const std::string& study,
                                                 const StudyChannels& channels, const std::vector<std::string>& posts,
                                                 Diagnostics& diagnostics);

/// Responses, and what was done to the time history that they were made of, a sentence each.
struct StudyResponse {
  FrequencyResponse response;
  std::vector<std::string> preparations = {};
};

/// The responses of a recording of a study: of a table of stepped sines as it stands, see ReadFrequencyResponse(); of a
/// time history as MeasureResponses() makes them, those in which the posts of the vehicle move as stated: `posts` are
/// their names, `shape` their shares. Where `posts` is empty, whatever the file holds. Adds every fault, at the study's
/// line where it contradicts the file; nothing when there was one.
std::optional<StudyResponse> ReadStudyRecording(const StudyRecording& recording, const std::string& study,
                                                const StudyChannels& channels, const std::vector<std::string>& posts,
                                                const std::vector<double>& shape, Diagnostics& diagnostics);

}  // namespace fourpost
