#include "identify/experiments/recording_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "analysis/text/utf8.h"
#include "identify/experiments/findings.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

struct OverTime {
  RecordingSummary summary;
  /// Of a recording of a measurement system, "RPC III"; else empty.
  std::string format;
  std::string description;
  bool has_several_rates = false;
  /// Of each column, as far as its file has them.
  std::vector<std::string> groups;
  std::vector<std::string> points;
  std::vector<std::string> descriptions;
  std::size_t samples = 0;
  /// Lines of the rows that first lack a number and are held, a column each; 0 where none is and of a MAT file.
  struct Lines {
    int missing = 0;
    int held = 0;
  };
  std::vector<Lines> lines;
  /// Why a fit to its channels would not take it.
  std::vector<std::string> refusals;
};

/// Of a column without a number whether it holds anything else, as "1.000,5".
bool HoldsText(const RecordedTable& table, const std::string& name) {
  const std::optional<std::size_t> column = table.FindColumn(name);
  if (!column) return false;
  for (std::size_t row = 0; row < table.rows(*column); ++row)
    if (!table.Text(row, *column).empty()) return true;
  return false;
}

/// Of columns that ReadTimeRecording was not asked for, since their units are not known: those that are not as long as
/// the times, and so no channels of this record.
void AddLengths(const RecordingSummary& summary, const RecordedTable& table, std::vector<std::string>& refusals) {
  if (!summary.time) return;
  Diagnostics faults;
  const std::size_t samples = table.rows(*table.FindColumn(summary.time->column));
  for (const ColumnSummary& column : summary.columns)
    if (const std::size_t rows = table.rows(*table.FindColumn(column.name)); !column.unit_known && rows != samples)
      faults.Report(kChannelLength, {}, {column.name, std::to_string(rows), std::to_string(samples)});
  for (const Diagnostic& fault : faults.items()) refusals.push_back(RefusalText(fault));
}

/// A record may be as uneven as times with few digits are.
constexpr double kUneven = 0.5;

/// What is not as of a good sensor.
void AddNoise(const SensorNoise& noise, double level, std::vector<std::string>& remarks) {
  if (noise.line_Hz) remarks.push_back("noise: line at " + Rounded(*noise.line_Hz, 3) + " Hz");
  else if (!noise.is_white) remarks.push_back("noise: not white, below " + Rounded(noise.below_Hz, 2) + " Hz");
  // Few levels have a distribution of their own.
  if (!noise.is_normal && noise.sd > 2 * level) remarks.emplace_back("noise: not normal");
}

/// By line, 0 of a MAT file, or sample.
std::string PlaceOf(int line, std::size_t sample) {
  return line > 0 ? "line " + std::to_string(line) : "sample " + std::to_string(sample + 1);
}

/// What would keep a study from using it, or should be looked at.
std::vector<std::string> Remarks(const ColumnSummary& column, const OverTime::Lines& lines, double duration_s) {
  std::vector<std::string> remarks;
  if (column.missing == column.samples) return {"no numbers"};
  if (column.missing > 0)
    remarks.push_back(std::to_string(column.missing) + " missing, first in " +
                      PlaceOf(lines.missing, column.first_missing));
  if (column.held > 0)
    remarks.push_back("held by the logger: " + std::to_string(column.held) + " samples, first in " +
                      PlaceOf(lines.held, column.first_held));
  if (column.unit.empty()) remarks.emplace_back("no unit");
  else if (!column.unit_known) remarks.push_back("unknown unit '" + column.unit + "'" + RecordedUnitHint(column.unit));
  if (column.minimum == column.maximum) remarks.emplace_back("constant");
  const auto clipped = [&](std::size_t samples, double at) {
    if (samples > 0) remarks.push_back("clipped: " + std::to_string(samples) + " samples at " + Rounded(at, 4));
  };
  clipped(column.clipped_top, column.maximum);
  clipped(column.clipped_bottom, column.minimum);
  // A straight line is a quarter of the variance: a motion of few periods has a slope of its own.
  constexpr double kDrifts = 1.7;
  if (std::abs(column.drift) > kDrifts * column.rms && column.rms > 0 && column.minimum != column.maximum)
    remarks.push_back("drifts by " + Rounded(column.drift, 2));
  else if (column.slow_drift)
    remarks.push_back("drifts by " + Rounded(*column.slow_drift, 2) + " over " + Rounded(duration_s, 3) +
                      " s beside its motion, `trend: remove` in a study takes it away");
  if (column.noise && column.noise->sd > 0) AddNoise(*column.noise, column.level, remarks);
  // A level's rounding has the deviation level/sqrt(12).
  if (column.is_dead) remarks.emplace_back("dead: nothing but noise of its converter");
  else if (column.rms > 0 && column.level / std::sqrt(12.0) > 0.05 * column.rms)
    remarks.push_back("coarse resolution: levels of " + Rounded(100 * column.level / column.rms, 2) + " % of its rms");
  return remarks;
}

std::string Joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// With the digits that it has, up to nine decimals.
std::string Short(double value) { return FormatNumber(std::round(1e9 * value), -9); }

std::string TimesText(const RecordingSummary& summary) {
  if (!summary.time) return "no column of rising times: name it in the study, time: {channel: NAME, unit: s}\n";
  const TimeSummary& time = *summary.time;
  std::string text = Short(time.start_s) + " to " + Short(time.end_s) + " s at " +
                     Short(std::round(1e4 * time.rate_Hz) / 1e4) + " Hz ('" + time.column + "')\n";
  if (time.is_guessed)
    text += "times are a guess, as '" + time.column +
            "' rises evenly: name it in the study, time: {channel: " + time.column + ", unit: s}\n";
  constexpr double kJitter = 0.01;
  if (time.jitter > kJitter)
    text += "jitter: steps differ by " + Rounded(100 * time.jitter, 2) + " % rms; state 'resample' in the study\n";
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < std::min(kMost, time.gaps.size()); ++i) {
    const TimeGap& gap = time.gaps[i];
    text += "gap: from " + Short(gap.from_s) + " to " + Short(gap.to_s) + " s" +
            (gap.line > 0 ? ", line " + std::to_string(gap.line) : "") + '\n';
  }
  if (time.gaps.size() > kMost) text += "and " + std::to_string(time.gaps.size() - kMost) + " more gaps\n";
  if (time.unevenness > kUneven)
    text += "uneven: up to " + Rounded(time.unevenness, 2) + " samples off a constant rate; resample the recording\n";
  return text;
}

/// One of all says nothing.
bool IsShown(const std::vector<std::string>& places) {
  return std::any_of(places.begin(), places.end(), [&](const std::string& place) { return place != places.front(); });
}

bool HasAny(const std::vector<std::string>& texts) {
  return std::any_of(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
}

double DurationOf(const RecordingSummary& summary) {
  return summary.time ? summary.time->end_s - summary.time->start_s : 0;
}

TextTable ChannelsTable(const OverTime& content) {
  std::vector<std::string> names = {"channel", "unit",  "minimum", "maximum", "mean",
                                    "rms",     "level", "noise",   "remarks"};
  if (HasAny(content.descriptions)) names.insert(names.begin() + 2, "description");
  if (IsShown(content.points)) names.insert(names.begin() + 2, "point");
  if (IsShown(content.groups)) names.insert(names.begin() + 2, "group");
  if (content.has_several_rates) names.insert(names.begin() + 2, "rate");
  TextTable table(names);
  for (std::size_t i = 0; i < content.summary.columns.size(); ++i) {
    const ColumnSummary& c = content.summary.columns[i];
    std::vector<std::string> row = {c.name,
                                    c.unit,
                                    Rounded(c.minimum, 4),
                                    Rounded(c.maximum, 4),
                                    Rounded(c.mean, 4),
                                    Rounded(c.rms, 4),
                                    Rounded(c.level, 2),
                                    c.noise ? Rounded(c.noise->sd, 3) : "",
                                    Joined(Remarks(c, content.lines[i], DurationOf(content.summary)))};
    if (HasAny(content.descriptions)) row.insert(row.begin() + 2, content.descriptions[i]);
    if (IsShown(content.points)) row.insert(row.begin() + 2, content.points[i]);
    if (IsShown(content.groups)) row.insert(row.begin() + 2, content.groups[i]);
    if (content.has_several_rates) row.insert(row.begin() + 2, Short(std::round(1e4 * c.rate_Hz) / 1e4) + " Hz");
    table.Add(row);
  }
  return table;
}

/// "RPC III: LIVING ROOM", each line of the description one.
std::string OriginText(const OverTime& content) {
  if (content.format.empty()) return "";
  return content.format + (content.description.empty() ? "" : ": " + content.description) + '\n';
}

/// As a study takes it, where g is a gram.
std::string StatedNoise(double sd, const std::string& recorded_unit) {
  const std::string name = WithoutBrackets(recorded_unit);
  const std::optional<Unit> recorded = ParseRecordedUnit(recorded_unit);
  const std::optional<Unit> stated = ParseUnit(name);
  if (stated && stated->dimension == recorded->dimension && stated->si == recorded->si)
    return ShortNumber(sd, 3) + " " + name;
  return ShortNumber(sd * recorded->si, 3) + " " + SiUnit(recorded->dimension);
}

/// When it rests, and the noise there as a study states it.
std::string RestText(const RecordingSummary& summary) {
  if (!summary.rest) return "no rest of half a second at begin or end, so the noise of sensors is not known\n";
  std::string noise;
  for (const ColumnSummary& column : summary.columns)
    if (column.noise && column.noise->sd > 0 && column.unit_known)
      noise += (noise.empty() ? "" : ", ") + column.name + ": " + StatedNoise(column.noise->sd, column.unit);
  return "at rest from " + Rounded(summary.rest->from_s, 3) + " to " + Rounded(summary.rest->to_s, 3) +
         " s after the first sample" +
         (noise.empty()
              ? "\n"
              : "; in a study, with the vehicle's sensors in place of these channels, as `fourpost info` of a study "
                "names them:\n  noise: {" +
                    noise + "}\n");
}

std::string TextOf(const OverTime& content) {
  std::string refusals;
  for (const std::string& refusal : content.refusals) refusals += "  " + refusal + '\n';
  if (!refusals.empty()) refusals = "a fit refuses this recording:\n" + refusals;
  return "time history, " + std::to_string(content.samples) + " samples, " + TimesText(content.summary) +
         OriginText(content) + ChannelsTable(content).Format() +
         "rms: about the mean; level: smallest difference between two values; noise: standard deviation at rest\n" +
         RestText(content.summary) + refusals;
}

Json NoiseJson(const SensorNoise& noise) {
  return {{"sd", noise.sd},
          {"white", noise.is_white},
          {"normal", noise.is_normal},
          {"skewness", noise.skewness},
          {"excess_kurtosis", noise.kurtosis},
          {"below_Hz", noise.below_Hz},
          {"line_Hz", noise.line_Hz ? Json(*noise.line_Hz) : Json()}};
}

Json JsonOf(const OverTime& content) {
  Json json = {
      {"kind", "time_history"}, {"time", nullptr}, {"channels", Json::array()}, {"refusals", content.refusals}};
  if (!content.format.empty()) json["format"] = content.format;
  if (!content.description.empty()) json["description"] = ValidUtf8(content.description);
  if (const std::optional<TimeSummary>& time = content.summary.time) {
    Json gaps = Json::array();
    for (const TimeGap& gap : time->gaps)
      gaps.push_back({{"line", gap.line == 0 ? Json() : Json(gap.line)}, {"from_s", gap.from_s}, {"to_s", gap.to_s}});
    json["time"] = {{"column", time->column},
                    {"start_s", time->start_s},
                    {"end_s", time->end_s},
                    {"rate_Hz", time->rate_Hz},
                    {"gaps", gaps},
                    {"unevenness_samples", time->unevenness},
                    {"jitter_share", time->jitter},
                    {"guessed", time->is_guessed}};
  }
  const std::optional<RestTime>& rest = content.summary.rest;
  json["rest_s"] = rest ? Json{rest->from_s, rest->to_s} : Json();
  for (std::size_t i = 0; i < content.summary.columns.size(); ++i) {
    const ColumnSummary& c = content.summary.columns[i];
    json["channels"].push_back({{"name", c.name},
                                {"unit", c.unit},
                                {"unit_known", c.unit_known},
                                {"samples", c.samples},
                                {"rate_Hz", c.rate_Hz > 0 ? Json(c.rate_Hz) : Json()},
                                {"missing", c.missing},
                                {"held", c.held},
                                {"minimum", c.minimum},
                                {"maximum", c.maximum},
                                {"mean", c.mean},
                                {"rms", c.rms},
                                {"level", c.level},
                                {"clipped_top", c.clipped_top},
                                {"clipped_bottom", c.clipped_bottom},
                                {"drift", c.drift},
                                {"slow_drift", c.slow_drift ? Json(*c.slow_drift) : Json()},
                                {"noise", c.noise ? NoiseJson(*c.noise) : Json()},
                                {"remarks", Remarks(c, content.lines[i], DurationOf(content.summary))}});
    if (!content.groups.empty() && !content.groups[i].empty())
      json["channels"].back()["group"] = ValidUtf8(content.groups[i]);
    if (!content.points.empty() && !content.points[i].empty())
      json["channels"].back()["point"] = ValidUtf8(content.points[i]);
    if (!content.descriptions.empty() && !content.descriptions[i].empty())
      json["channels"].back()["description"] = ValidUtf8(content.descriptions[i]);
  }
  return json;
}

}  // namespace

std::string RefusalText(const Diagnostic& fault) {
  return (fault.place.line > 0 ? "line " + std::to_string(fault.place.line) + ": " : "") + fault.message +
         (fault.id.empty() ? "" : " [" + fault.id + "]");
}

std::vector<RecordedChannel> ChannelsInKnownUnits(const RecordedTable& table, const RecordingSummary& summary) {
  std::vector<RecordedChannel> channels;
  for (const ColumnSummary& column : summary.columns)
    if (column.unit_known && (column.missing < column.samples || HoldsText(table, column.name)))
      channels.push_back({{column.name}, ParseRecordedUnit(column.unit)->dimension, "a channel"});
  return channels;
}

RecordingLook LookOverTime(const std::filesystem::path& file, const RecordedTable& table,
                           const RecordingSummary& summary, const std::vector<RecordedChannel>& channels,
                           const FurtherRefusals& further) {
  OverTime content{.summary = summary, .samples = table.names().empty() ? 0 : table.rows(0)};
  if (const RecordingColumns* recorded = table.recording()) {
    content.format = recorded->header().format;
    content.description = recorded->header().description;
    content.has_several_rates = recorded->HasSeveralRates();
    for (const ColumnSummary& column : summary.columns) {
      const RecordingChannel& channel = *recorded->channel(*table.FindColumn(column.name));
      content.groups.push_back(channel.group);
      content.points.push_back(channel.point);
      content.descriptions.push_back(channel.description);
    }
  }
  if (!channels.empty()) {
    RecordedChannel time = kTimeColumn;
    if (summary.time) time.names = {summary.time->column};
    Diagnostics faults;
    std::optional<TimeRecording> recording;
    if (further) recording = ReadTimeRecording(file, channels, faults, time);
    else CheckTimeRecording(table, channels, faults, time);
    for (const Diagnostic& fault : faults.items())
      if (fault.severity == Severity::kError) content.refusals.push_back(RefusalText(fault));
    if (recording)
      for (std::string& refusal : further(*recording)) content.refusals.push_back(std::move(refusal));
  }
  AddLengths(summary, table, content.refusals);
  for (const ColumnSummary& column : summary.columns)
    content.lines.push_back({column.missing > 0 ? table.line(column.first_missing) : 0,
                             column.held > 0 ? table.line(column.first_held) : 0});
  return {TextOf(content), JsonOf(content)};
}

}  // namespace fourpost
