#include "identify/draft/file_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "analysis/files/frequency_response_file.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_layout.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/static_loads.h"
#include "analysis/files/time_recording.h"
#include "analysis/measured_response/measured_response.h"
#include "analysis/text/name_meaning.h"
#include "analysis/text/named.h"
#include "analysis/text/text_table.h"
#include "identify/draft/gapless_stretch.h"
#include "identify/draft/post_match.h"
#include "identify/study_file/source_recording.h"
#include "vehicles/bench/recording_check.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

std::string FirstError(const Diagnostics& found) {
  for (const Diagnostic& item : found.items())
    if (item.severity == Severity::kError) return item.message;
  return "no recording";
}

/// A pattern that the name of a file speaks of.
std::vector<double> ShapeByName(const std::filesystem::path& file, const Vehicle& vehicle) {
  const std::set<std::string> words = MeaningOf(file.stem().string()).words;
  const auto has = [&](const char* word) { return words.contains(word); };
  const char* pattern = has("heave") || has("bounce") ? "heave"
                        : has("pitch")                ? "pitch"
                        : has("roll")                 ? "roll"
                        : has("warp") || has("twist") ? "warp"
                                                      : "";
  try {
    return *pattern == '\0' ? std::vector<double>() : PostPattern(vehicle, pattern);
  } catch (const PatternError&) {
    return {};
  }
}

void ReadSines(const Vehicle& vehicle, FileReading& reading) {
  Diagnostics found;
  // An amplitude that is not in the file is for the user to state; the shape of responses depends little on it.
  constexpr double kAmplitude_m = 5e-3;
  std::optional<FrequencyResponse> response = ReadFrequencyResponse(reading.path, found, kAmplitude_m);
  if (!response) {
    reading.reason = FirstError(found);
    return;
  }
  reading.kind = FileReading::Kind::kSines;
  for (const ChannelResponse& channel : response->channels)
    reading.channels.push_back({channel.name, ParseUnit(channel.unit)->dimension});
  reading.motions.push_back({*std::move(response), ShapeByName(reading.path, vehicle)});
}

void ReadLoads(FileReading& reading) {
  Diagnostics found;
  const auto loads = ReadStaticLoads(reading.path, found);
  if (!loads) {
    reading.reason = FirstError(found);
    return;
  }
  reading.kind = FileReading::Kind::kLoads;
  for (const StaticMeasurement& load : *loads) reading.channels.push_back({load.name, load.dimension});
}

/// Of each post of the vehicle: the mean of its channels.
std::vector<double> ShapeOf(const Vehicle& vehicle, const FileReading& reading, const MeasuredResponses& measured,
                            const PostShares& shares) {
  std::vector<double> shape;
  for (const Post& post : vehicle.posts) {
    const auto match = std::find_if(reading.posts.begin(), reading.posts.end(),
                                    [&](const ChannelMatch& one) { return one.name == post.name; });
    double sum = 0;
    for (const SourceChannel& channel : match->source.channels)
      sum += shares.share[*IndexOf(channel.name, measured.posts)] / static_cast<double>(match->source.channels.size());
    shape.push_back(sum);
  }
  return shape;
}

/// Stated ones, a text for each column.
std::vector<std::string> UnitsByColumn(const RecordedTable& table, const std::vector<StatedUnit>& units) {
  std::vector<std::string> by_column;
  for (const std::string& name : table.names()) by_column.push_back(UnitStatedOf(units, name));
  return by_column;
}

void AddChannels(const RecordedTable& table, const std::string& time, FileReading& reading) {
  for (std::size_t column = 0; column < table.names().size(); ++column) {
    const std::string& name = table.names()[column];
    const std::string stated = UnitStatedOf(reading.units, name);
    const std::optional<Unit> unit = ParseRecordedUnit(stated.empty() ? table.unit(column) : stated);
    const bool is_there = std::any_of(reading.channels.begin(), reading.channels.end(),
                                      [&](const OfferedChannel& channel) { return channel.name == name; });
    if (name == time || is_there || table.HoldsText(column)) continue;
    if (unit) reading.channels.push_back({name, unit->dimension});
    else if (!name.empty()) reading.unread.emplace_back(name, table.unit(column));
  }
}

/// The channels of another file, and what is known of them.
void AddBeside(const OtherFile& other, FileReading& reading) {
  Diagnostics unheard;
  const std::optional<RecordedTable> table = ReadRecordedTable(other.path, unheard);
  if (!table) return;
  AddChannels(*table, TimesColumn(*table), reading);
  DraftedPreparation beside = PreparationOf(*table, UnitsByColumn(*table, reading.units));
  std::vector<ColumnSummary>& columns = reading.preparation.summary.columns;
  for (ColumnSummary& column : beside.summary.columns)
    if (reading.preparation.Find(column.name) == nullptr) columns.push_back(std::move(column));
  reading.preparation.times.bridge_s = std::max(reading.preparation.times.bridge_s, beside.times.bridge_s);
  if (reading.preparation.why_bridged.empty()) reading.preparation.why_bridged = beside.why_bridged;
}

/// Most channels of motion have far less of it in the last quarter than in the one in which the vehicle was let go.
bool ComesToRest(const RecordedTable& table, const FileReading& reading) {
  constexpr double kFarLess = 0.2;
  int moving = 0;
  int resting = 0;
  for (const OfferedChannel& channel : reading.channels) {
    if (!(channel.dimension == kLength || channel.dimension == kAcceleration)) continue;
    const std::size_t column = *table.FindColumn(channel.name);
    const std::size_t rows = table.rows(column);
    const auto spread = [&](std::size_t from, std::size_t to) {
      double sum = 0;
      double squares = 0;
      for (std::size_t row = from; row < to; ++row) {
        const double value = table.Number(row, column).value_or(0);
        sum += value;
        squares += value * value;
      }
      const auto count = static_cast<double>(std::max<std::size_t>(1, to - from));
      return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
    };
    // It may rest before it is let go.
    const double loudest =
        std::max({spread(0, rows / 4), spread(rows / 4, rows / 2), spread(rows / 2, rows - rows / 4)});
    if (loudest == 0) continue;
    ++moving;
    if (spread(rows - rows / 4, rows) < kFarLess * loudest) ++resting;
  }
  return moving > 0 && 2 * resting > moving;
}

/// Driven by actuators, or let go.
void ReadAtRestingPosts(const RecordedTable& table, const Vehicle& vehicle, FileReading& reading) {
  reading.actuators = MatchChannels(SoughtActuators(vehicle), reading.channels, HasSides(vehicle));
  for (const ChannelMatch& actuator : reading.actuators)
    for (const SourceChannel& source : actuator.source.channels)
      std::erase_if(reading.channels, [&](const OfferedChannel& channel) { return channel.name == source.name; });
  reading.is_release = reading.actuators.empty() && ComesToRest(table, reading);
  if (!reading.actuators.empty() || reading.is_release) reading.kind = FileReading::Kind::kHistory;
}

/// Whether the damper would deliver work.
bool IsForceReversed(const RecordedTable& table, const FileReading& reading) {
  const std::array<RecordedChannel, 2> wanted = {AsRecorded(BenchChannel(reading, kLength), kLength, "the extension"),
                                                 AsRecorded(BenchChannel(reading, kForce), kForce, "the tension")};
  SourceChannel time(reading.preparation.summary.time ? reading.preparation.summary.time->column : "");
  time.unit = reading.preparation.time_unit;
  Diagnostics unheard;
  const std::optional<TimeRecording> recording =
      ReadTimeRecording(table, wanted, unheard, TimeColumn(time), reading.preparation.times);
  return recording && IsForceReversed(*recording);
}

/// Of what is stated of any file what names a channel of this one, or of those beside it.
std::vector<StatedUnit> UnitsIn(const RecordedTable& table, const FileReading& reading) {
  std::vector<StatedUnit> units;
  std::copy_if(reading.units.begin(), reading.units.end(), std::back_inserter(units), [&](const StatedUnit& stated) {
    const auto names = [&](const std::string& name) { return stated.Names(name); };
    return std::any_of(table.names().begin(), table.names().end(), names) ||
           std::any_of(reading.channels.begin(), reading.channels.end(),
                       [&](const OfferedChannel& channel) { return names(channel.name); });
  });
  return units;
}

/// As stated; where the file has none, seconds.
void TakeUnitOfTimes(const RecordedTable& table, const std::string& time, FileReading& reading) {
  DraftedPreparation& preparation = reading.preparation;
  preparation.time_unit = UnitStatedOf(reading.units, time);
  preparation.is_time_unit_guessed =
      preparation.time_unit.empty() && !ParseRecordedUnit(table.unit(*table.FindColumn(time)));
  if (!preparation.is_time_unit_guessed) return;
  preparation.time_unit = "s";
  reading.units.push_back({time, "s"});
}

/// Where a gap is too long to be bridged, motion is compared beside it.
void TakeLongestStretch(const RecordedTable& table, FileReading& reading, RigPreparation& preparation) {
  if (reading.preparation.over_all_gaps_s <= kLongestBridge_s) return;
  const std::optional<GaplessStretch> longest = LongestGapless(table, reading);
  if (!longest) return;
  preparation.times.bridge_s = reading.preparation.over_all_gaps_s;
  preparation.start_s = longest->from_s;
  preparation.end_s = longest->to_s;
  reading.missed.push_back("motion was compared from " + Rounded(longest->from_s, 4) + " to " +
                           Rounded(longest->to_s, 4) + " s, the longest stretch without a gap above " +
                           Rounded(1e3 * kLongestBridge_s, 2) + " ms");
}

void ReadHistory(const RecordedTable& table, const Vehicle& vehicle, const std::vector<PostChannel>& posts,
                 FileReading& reading) {
  const std::string time = TimesColumn(table);
  if (time.empty()) {
    reading.reason = "no column of times";
    return;
  }
  AddChannels(table, time, reading);
  const std::vector<OtherFile> others = reading.preparation.times.others;
  reading.preparation = PreparationOf(table, UnitsByColumn(table, reading.units));
  reading.preparation.times.others = others;
  TakeUnitOfTimes(table, time, reading);
  for (const OtherFile& other : others) AddBeside(other, reading);
  if (vehicle.posts.empty()) {
    const bool is_bench = !BenchChannel(reading, kLength).name.empty() && !BenchChannel(reading, kForce).name.empty();
    if (is_bench) reading.kind = FileReading::Kind::kBench;
    if (is_bench) reading.has_force_reversed = IsForceReversed(table, reading);
    else reading.reason = "no displacement and force of a damper" + WithoutUnit(reading);
    return;
  }
  MatchPosts(vehicle, posts, reading);
  if (reading.posts.size() < vehicle.posts.size()) {
    reading.misspelt_post = MisspeltPost(reading);
    reading.reason = PostsMissing(vehicle, reading);
    reading.is_without_posts = reading.posts.empty();
    if (reading.is_without_posts) ReadAtRestingPosts(table, vehicle, reading);
    return;
  }
  reading.kind = FileReading::Kind::kHistory;
  for (ChannelMatch& post : reading.posts) RemoveDrifts(reading.preparation, post);
  ResponseRequest request{.files = {reading.path},
                          .preparation = {.times = reading.preparation.times, .units = UnitsIn(table, reading)}};
  for (const ChannelMatch& post : reading.posts)
    for (const SourceChannel& channel : post.source.channels) request.posts.push_back({channel.name, channel.name});
  TakeLongestStretch(table, reading, request.preparation);
  Diagnostics found;
  std::optional<MeasuredResponses> measured = MeasureResponses(request, found);
  if (!measured) {
    reading.not_compared = FirstError(found);
    return;
  }
  reading.missed.insert(reading.missed.end(), measured->missed.begin(), measured->missed.end());
  if (measured->kind == ExcitationKind::kStepped) reading.kind = FileReading::Kind::kDwells;
  for (MeasuredResponse& response : measured->responses) {
    std::vector<double> shape = ShapeOf(vehicle, reading, *measured, response.shares);
    reading.motions.push_back({std::move(response.response), std::move(shape)});
  }
}

}  // namespace

SourceChannel BenchChannel(const FileReading& reading, const Dimension& dimension) {
  for (const OfferedChannel& channel : reading.channels) {
    if (!(channel.dimension == dimension)) continue;
    ChannelSource source{.channels = {SourceChannel(channel.name)}};
    StateUnits(reading.units, source);
    return source.channels.front();
  }
  return {};
}

void StateUnits(const std::vector<StatedUnit>& units, ChannelSource& source) {
  for (SourceChannel& channel : source.channels)
    if (const std::string unit = UnitStatedOf(units, channel.name); !unit.empty()) channel.unit = unit;
}

std::optional<std::string> PatternOfShape(const Vehicle& vehicle, const std::vector<double>& shape) {
  constexpr double kNear = 0.1;
  for (const std::string_view pattern : kPostPatterns) {
    try {
      const std::vector<double> exact = PostPattern(vehicle, pattern);
      for (const double sense : {1.0, -1.0}) {
        double off = 0;
        for (std::size_t p = 0; p < shape.size(); ++p) off = std::max(off, std::abs(sense * shape[p] - exact[p]));
        if (off < kNear) return std::string(pattern);
      }
    } catch (const PatternError&) {
      continue;
    }
  }
  return std::nullopt;
}

FileReading ReadForDraft(const std::filesystem::path& file, const Vehicle& vehicle, const DraftStatements& stated,
                         const std::vector<std::filesystem::path>& beside) {
  FileReading reading{.path = file, .units = stated.units};
  for (const std::filesystem::path& other : beside) reading.preparation.times.others.push_back({.path = other});
  Diagnostics found;
  try {
    const std::optional<RecordedTable> table = ReadRecordedTable(file, found);
    if (table) reading.columns = table->names();
    if (!table) reading.reason = FirstError(found);
    else if (IsSteppedSine(*table)) ReadSines(vehicle, reading);
    else if (table->FindColumn("quantity") && table->FindColumn("value")) ReadLoads(reading);
    else ReadHistory(*table, vehicle, stated.posts, reading);
  } catch (const FaultyInput& faulty) {
    reading.kind = FileReading::Kind::kUnread;
    reading.reason = FirstError(faulty.diagnostics());
  }
  for (std::vector<ChannelMatch>* matches : {&reading.posts, &reading.actuators})
    for (ChannelMatch& match : *matches) StateUnits(stated.units, match.source);
  return reading;
}

}  // namespace fourpost
