#include "identify/experiments/four_post/study_recording.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/frequency_response_file.h"
#include "analysis/files/recording_layout.h"
#include "analysis/text/named.h"
#include "analysis/text/number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/study_file/source_recording.h"

namespace fourpost {
namespace {

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// "{FL: 1, FR: -1}"
std::string SharesText(const std::vector<std::string>& posts, const std::vector<double>& shares) {
  std::string text;
  for (std::size_t p = 0; p < posts.size(); ++p)
    text += (p > 0 ? ", " : "") + posts[p] + ": " + FormatNumber(shares[p]);
  return "{" + text + "}";
}

/// 1 or -1 where the found motion is the stated one in that sense; 0 where it is another.
double SenseOf(const std::vector<double>& found, const std::vector<double>& stated) {
  constexpr double kNear = 0.1;
  for (const double sense : {1.0, -1.0}) {
    bool is_same = true;
    for (std::size_t p = 0; p < stated.size(); ++p) is_same = is_same && std::abs(sense * found[p] - stated[p]) < kNear;
    if (is_same) return sense;
  }
  return 0;
}

/// The same posts move, but the reference moves against the one that was found.
void Turn(FrequencyResponse& response) {
  for (ChannelResponse& channel : response.channels)
    for (std::complex<double>& value : channel.response) value = -value;
}

/// What is done to a channel over time before responses are made of it.
bool IsPrepared(const SourceChannel& channel) {
  return !channel.unit.empty() || !channel.offset.empty() || channel.has_trend || channel.high_pass_Hz ||
         channel.integrated_above_Hz;
}

class MeasuredRecording {
 public:
  MeasuredRecording(const StudyRecording& recording, const std::string& study, const StudyChannels& channels,
                    Diagnostics& diagnostics)
      : recording_(recording), channels_(channels), place_{study, recording.line}, diagnostics_(diagnostics) {}

  std::optional<StudyResponse> Read(const std::vector<std::string>& posts, const std::vector<double>& shape) {
    std::optional<MeasuredResponses> measured = Measure();
    if (!measured) return std::nullopt;
    std::vector<std::string> preparations = std::move(measured->preparations);
    preparations.insert(preparations.end(), measured->missed.begin(), measured->missed.end());
    preparations.push_back("responses of a " + KindInWords(measured->kind));
    if (recording_.filter)
      preparations.push_back("low-pass of " + FormatNumber(recording_.filter->cutoff_Hz) + " Hz taken off the posts");
    if (posts.empty()) return StudyResponse{std::move(measured->responses.front().response), preparations};
    const std::optional<std::vector<std::size_t>> places = PlacesOf(posts, *measured);
    std::optional<FrequencyResponse> chosen = places ? Chosen(posts, shape, *places, *measured) : std::nullopt;
    if (!chosen) return std::nullopt;
    return StudyResponse{*std::move(chosen), std::move(preparations)};
  }

  std::optional<HistoryContent> Content(const std::vector<std::string>& posts) {
    const std::optional<MeasuredResponses> measured = Measure();
    const auto places = measured ? PlacesOf(posts, *measured) : std::nullopt;
    if (!places) return std::nullopt;
    HistoryContent content{.channels = NamesOf(measured->responses.front().response.channels), .shapes = {}};
    for (const MeasuredResponse& response : measured->responses) {
      std::vector<double>& shape = content.shapes.emplace_back();
      for (const std::size_t place : *places) shape.push_back(response.shares.share[place]);
    }
    return content;
  }

 private:
  std::optional<MeasuredResponses> Measure() {
    if (recording_.repeats > 1) {
      diagnostics_.Report(kSineRepeatsCounted, place_, {recording_.name});
      return std::nullopt;
    }
    return MeasureResponses({.files = {recording_.file},
                             .posts = recording_.post_channels,
                             .filter = recording_.filter,
                             .preparation = Preparation()},
                            diagnostics_);
  }

  RigPreparation Preparation() const {
    RigPreparation preparation{.times = recording_.preparation,
                               .channels = StatedChannels(),
                               .start_s = recording_.start_s,
                               .end_s = recording_.end_s};
    if (recording_.time) preparation.time = TimeColumn(recording_.time);
    return preparation;
  }

  std::vector<RecordedChannel> StatedChannels() const {
    std::vector<RecordedChannel> stated;
    for (const SourceChannel& post : recording_.post_sources) stated.push_back(AsRecorded(post, kLength, ""));
    for (const auto& [sensor, source] : channels_)
      for (const SourceChannel& channel : source.channels) {
        stated.push_back(AsRecorded(channel, {}, ""));
        stated.back().factor = 1;
        stated.back().delay_s = 0;
      }
    return stated;
  }

  /// Of each post of the vehicle among those of the recording.
  std::optional<std::vector<std::size_t>> PlacesOf(const std::vector<std::string>& posts,
                                                   const MeasuredResponses& measured) {
    std::vector<std::size_t> places;
    for (const std::string& post : posts)
      if (const std::optional<std::size_t> place = IndexOf(post, measured.posts)) places.push_back(*place);
    if (places.size() == posts.size()) return places;
    // One post and one channel need no names.
    if (posts.size() == 1 && measured.posts.size() == 1) return std::vector<std::size_t>{0};
    diagnostics_.Report(kSinePostsUnmapped, place_, {recording_.name, Joined(measured.posts), Joined(posts)});
    return std::nullopt;
  }

  std::optional<FrequencyResponse> Chosen(const std::vector<std::string>& posts, const std::vector<double>& shape,
                                          const std::vector<std::size_t>& places, MeasuredResponses& measured) {
    std::optional<FrequencyResponse> chosen;
    std::string found;
    int count = 0;
    for (MeasuredResponse& response : measured.responses) {
      std::vector<double> shares;
      for (const std::size_t place : places) shares.push_back(response.shares.share[place]);
      const std::string text = SharesText(posts, shares);
      if (found.find(text) == std::string::npos) found += (found.empty() ? "" : " and ") + text;
      const double sense = SenseOf(shares, shape);
      if (sense == 0 || count++ > 0) continue;
      if (sense < 0) Turn(response.response);
      chosen = std::move(response.response);
    }
    if (count == 0)
      diagnostics_.Report(kSinePostsOtherwise, place_, {recording_.name, found, SharesText(posts, shape)});
    if (count > 1) diagnostics_.Report(kSineSeveralAmplitudes, place_, {recording_.name, std::to_string(count)});
    return count == 1 ? std::move(chosen) : std::nullopt;
  }

  const StudyRecording& recording_;
  const StudyChannels& channels_;
  Place place_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool IsOverTime(const StudyRecording& recording) {
  // Its faults are reported by the one who reads it in earnest.
  Diagnostics unheard;
  const std::optional<RecordedTable> table = ReadRecordedTable(recording.file, unheard);
  if (!table || IsSteppedSine(*table)) return false;
  return IsTimeHistory(*table) || (recording.time && table->FindColumn(recording.time->name));
}

std::optional<SourceChannel> TimesAsIn(const std::vector<StudyRecording>& like, const RecordedTable& table) {
  for (const StudyRecording& recording : like)
    if (recording.time && table.FindColumn(recording.time->name)) return recording.time;
  return std::nullopt;
}

std::optional<HistoryContent> ReadHistoryContent(const StudyRecording& recording, const std::string& study,
                                                 const StudyChannels& channels, const std::vector<std::string>& posts,
                                                 Diagnostics& diagnostics) {
  return MeasuredRecording(recording, study, channels, diagnostics).Content(posts);
}

std::optional<StudyResponse> ReadStudyRecording(const StudyRecording& recording, const std::string& study,
                                                const StudyChannels& channels, const std::vector<std::string>& posts,
                                                const std::vector<double>& shape, Diagnostics& diagnostics) {
  if (IsOverTime(recording)) return MeasuredRecording(recording, study, channels, diagnostics).Read(posts, shape);
  if (recording.IsOfHistory()) diagnostics.Report(kSineKeysOfHistory, {study, recording.line}, {recording.name});
  for (const auto& [sensor, source] : channels)
    for (const SourceChannel& channel : source.channels)
      if (IsPrepared(channel))
        diagnostics.Report(kSineChannelOfHistory, {study, source.line}, {sensor, recording.name});
  std::optional<FrequencyResponse> read = ReadFrequencyResponse(recording.file, diagnostics, recording.amplitude_m);
  if (!read) return std::nullopt;
  return StudyResponse{.response = *std::move(read)};
}

}  // namespace fourpost
