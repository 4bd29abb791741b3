#include "identify/draft/gapless_stretch.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "analysis/files/time_recording.h"
#include "identify/study_file/source_recording.h"

namespace fourpost {
namespace {

/// All channels of the file itself, over every gap.
std::optional<TimeRecording> Bridged(const RecordedTable& table, const FileReading& reading) {
  std::vector<RecordedChannel> wanted;
  const auto want = [&](const std::string& name, const Dimension& dimension) {
    ChannelSource source{.channels = {SourceChannel(name)}};
    StateUnits(reading.units, source);
    wanted.push_back(AsRecorded(source.channels.front(), dimension, name));
  };
  for (const OfferedChannel& channel : reading.channels)
    if (table.FindColumn(channel.name)) want(channel.name, channel.dimension);
  for (const ChannelMatch& post : reading.posts)
    for (const SourceChannel& channel : post.source.channels) want(channel.name, kLength);
  SourceChannel time(reading.preparation.summary.time ? reading.preparation.summary.time->column : "");
  time.unit = reading.preparation.time_unit;
  TimePreparation times = reading.preparation.times;
  times.bridge_s = reading.preparation.over_all_gaps_s;
  times.others.clear();
  Diagnostics unheard;
  return ReadTimeRecording(table, wanted, unheard, TimeColumn(time), times);
}

}  // namespace

std::optional<GaplessStretch> LongestGapless(const RecordedTable& table, const FileReading& reading) {
  const std::optional<TimeRecording> recording = Bridged(table, reading);
  if (!recording) return std::nullopt;
  std::vector<std::pair<double, double>> gaps;
  for (const std::vector<BridgedGap>& of_channel : recording->gaps)
    for (const BridgedGap& gap : of_channel)
      if (gap.to_s - gap.from_s > kLongestBridge_s) gaps.emplace_back(gap.from_s, gap.to_s);
  if (gaps.empty()) return std::nullopt;
  gaps.emplace_back(recording->end_s, recording->end_s);
  std::sort(gaps.begin(), gaps.end());
  GaplessStretch longest{recording->start_s, recording->start_s};
  double from_s = recording->start_s;
  for (const auto& [begin_s, end_s] : gaps) {
    if (begin_s - from_s > longest.to_s - longest.from_s) longest = {from_s, begin_s};
    from_s = std::max(from_s, end_s);
  }
  return longest;
}

}  // namespace fourpost
