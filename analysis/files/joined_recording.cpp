#include <algorithm>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/sample_times.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/uneven_samples.h"

namespace fourpost {
namespace {

bool HasOneOf(const RecordedTable& table, const RecordedChannel& channel) {
  return std::any_of(channel.names.begin(), channel.names.end(),
                     [&](const std::string& name) { return table.FindColumn(name).has_value(); });
}

/// Channels of `part` at the times of `whole`, which loses what the part does not cover.
void Join(const TimeRecording& part, double delay_s, std::span<const std::size_t> places, std::size_t& samples,
          TimeRecording& whole) {
  std::vector<double> times;
  for (std::size_t k = 0; k < part.samples(); ++k) times.push_back(part.time_s(k) - delay_s);
  std::vector<double> grid;
  std::size_t first = 0;
  const double rounding = 1e-6 * whole.step_s;
  while (first < samples && whole.time_s(first) < times.front() - rounding) ++first;
  std::size_t last = first;
  while (last < samples && whole.time_s(last) <= times.back() + rounding) grid.push_back(whole.time_s(last++));
  for (std::vector<double>& channel : whole.channels)
    if (!channel.empty())
      channel = {channel.begin() + static_cast<std::ptrdiff_t>(first),
                 channel.begin() + static_cast<std::ptrdiff_t>(last)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    whole.channels[places[i]] = InterpolatedAt(times, part.channels[i], grid);
    for (const BridgedGap& gap : part.gaps[i])
      whole.gaps[places[i]].push_back({gap.from_s - delay_s, gap.to_s - delay_s});
  }
  samples = grid.size();
  if (grid.empty()) return;
  whole.start_s = grid.front();
  whole.end_s = grid.back();
  whole.preparations.insert(whole.preparations.end(), part.preparations.begin(), part.preparations.end());
}

}  // namespace

std::optional<TimeRecording> ReadTimeRecording(const std::filesystem::path& file,
                                               std::span<const RecordedChannel> wanted, Diagnostics& diagnostics,
                                               const RecordedChannel& time, const TimePreparation& preparation) {
  const std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics);
  if (!table) return std::nullopt;
  // Of each file the channels that none before it has.
  std::vector<std::size_t> open;
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    (HasOneOf(*table, wanted[i]) || preparation.others.empty() ? own : open).push_back(i);
  const auto chosen = [&](const std::vector<std::size_t>& places) {
    std::vector<RecordedChannel> some;
    for (const std::size_t place : places) some.push_back(wanted[place]);
    return some;
  };
  if (open.empty() || own.empty()) return ReadTimeRecording(*table, wanted, diagnostics, time, preparation);
  std::optional<TimeRecording> first = ReadTimeRecording(*table, chosen(own), diagnostics, time, preparation);
  if (!first) return std::nullopt;
  TimeRecording whole = *first;
  std::size_t samples = first->samples();
  whole.channels.assign(wanted.size(), {});
  whole.gaps.assign(wanted.size(), {});
  for (std::size_t i = 0; i < own.size(); ++i) {
    whole.channels[own[i]] = std::move(first->channels[i]);
    whole.gaps[own[i]] = std::move(first->gaps[i]);
  }
  for (const OtherFile& other : preparation.others) {
    const std::optional<RecordedTable> beside = ReadRecordedTable(other.path, diagnostics);
    if (!beside) return std::nullopt;
    std::vector<std::size_t> here;
    for (const std::size_t place : open)
      if (HasOneOf(*beside, wanted[place])) here.push_back(place);
    if (here.empty()) continue;
    std::erase_if(open, [&](std::size_t place) { return std::find(here.begin(), here.end(), place) != here.end(); });
    // Another recorder may call its times otherwise.
    RecordedChannel times = HasOneOf(*beside, time) ? time : kTimeColumn;
    if (!HasOneOf(*beside, times))
      if (const std::string usual = TimesColumn(*beside); !usual.empty()) times.names = {usual};
    const std::optional<TimeRecording> part = ReadTimeRecording(*beside, chosen(here), diagnostics, times, preparation);
    if (!part) return std::nullopt;
    whole.preparations.push_back("with " + other.path.filename().string() +
                                 (other.delay_s != 0 ? ", " + MillisecondsText(other.delay_s) + " ahead" : ""));
    Join(*part, other.delay_s, here, samples, whole);
  }
  for (const std::size_t place : open)
    diagnostics.Report(kChannelInNoFile, {file.string()}, {wanted[place].names.front(), wanted[place].what});
  if (samples < 4) diagnostics.Report(kTooFewSamples, {file.string()}, {std::to_string(samples)});
  if (!open.empty() || samples < 4) return std::nullopt;
  return whole;
}

}  // namespace fourpost
