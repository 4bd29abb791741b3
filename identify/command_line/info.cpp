#include <algorithm>
#include <cmath>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/files/csv.h"
#include "analysis/files/frequency_response_file.h"
#include "analysis/files/json_text.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_layout.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/static_loads.h"
#include "analysis/files/time_recording.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/print.h"
#include "identify/experiments/bench/bench_data.h"
#include "vehicles/bench/recording_check.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

struct OverTime {
  RecordingSummary summary;
  /// Lines of the rows that lack a number first, a column each; 0 where none does and of a MAT file.
  std::vector<int> missing_lines;
  /// Why a fit to all its channels would not take it; of a displacement and a force alone, one of a damper.
  std::vector<std::string> refusals;
};

/// A file that was read, and what it holds.
struct Described {
  std::string file;
  std::variant<OverTime, FrequencyResponse, std::vector<StaticMeasurement>> content;
};

enum class Layout { kOverTime, kSteppedSine, kStatic };

/// Known by the names of its columns.
Layout LayoutOf(const RecordedTable& table) {
  if (IsSteppedSine(table)) return Layout::kSteppedSine;
  if (table.FindColumn("quantity") && table.FindColumn("value")) return Layout::kStatic;
  return Layout::kOverTime;
}

std::string RefusalOf(const Diagnostic& fault) {
  return (fault.place.line > 0 ? "line " + std::to_string(fault.place.line) + ": " : "") + fault.message +
         (fault.id.empty() ? "" : " [" + fault.id + "]");
}

/// Of a recording of nothing but a displacement and a force, which is that of a damper on its bench, in this order.
std::vector<RecordedChannel> BenchChannels(const std::vector<RecordedChannel>& channels) {
  std::vector<RecordedChannel> bench;
  for (const Dimension& dimension : {kLength, kForce})
    for (const RecordedChannel& channel : channels)
      if (channel.dimension == dimension) bench.push_back(channel);
  return channels.size() == 2 && bench.size() == 2 && bench[0].dimension != bench[1].dimension
             ? bench
             : std::vector<RecordedChannel>();
}

/// Of a column without a number whether it holds anything else, as "1.000,5".
bool HoldsText(const RecordedTable& table, const std::string& name) {
  const std::optional<std::size_t> column = table.FindColumn(name);
  if (!column) return false;
  for (std::size_t row = 0; row < table.rows(*column); ++row)
    if (!table.Text(row, *column).empty()) return true;
  return false;
}

/// By the reader that fits use, of channels in a unit that it knows; and by the check of bench recordings.
std::vector<std::string> Refusals(const std::filesystem::path& file, const RecordedTable& table,
                                  const RecordingSummary& summary) {
  RecordedChannel time = kTimeColumn;
  if (summary.time) time.names = {summary.time->column};
  std::vector<RecordedChannel> wanted;
  for (const ColumnSummary& column : summary.columns)
    if (column.unit_known && (column.missing < column.samples || HoldsText(table, column.name)))
      wanted.push_back({{column.name}, ParseRecordedUnit(column.unit)->dimension, "a channel"});
  if (wanted.empty()) return {};
  const std::vector<RecordedChannel> bench = BenchChannels(wanted);
  if (!bench.empty()) wanted = bench;
  Diagnostics faults;
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, faults, time);
  std::vector<std::string> refusals;
  for (const Diagnostic& fault : faults.items()) refusals.push_back(RefusalOf(fault));
  if (!recording || bench.empty()) return refusals;
  Diagnostics findings;
  CheckBenchRecording(*recording, kLongestStroke_m, file.string(), findings);
  for (const Diagnostic& finding : findings.items())
    if (finding.severity == Severity::kError)
      refusals.push_back("as a recording of a damper bench: " + RefusalOf(finding));
  return refusals;
}

/// Of columns that ReadTimeRecording was not asked for, since their units are not known: those that are not as long as
/// the times, and so no channels of this record.
void AddLengths(const RecordingSummary& summary, const RecordedTable& table, std::vector<std::string>& refusals) {
  if (!summary.time) return;
  Diagnostics faults;
  const std::size_t samples = table.rows(*table.FindColumn(summary.time->column));
  for (const ColumnSummary& column : summary.columns)
    if (!column.unit_known && column.samples != samples)
      faults.Report(kChannelLength, {}, {column.name, std::to_string(column.samples), std::to_string(samples)});
  for (const Diagnostic& fault : faults.items()) refusals.push_back(RefusalOf(fault));
}

OverTime Look(const std::filesystem::path& file, const RecordedTable& table) {
  OverTime content = {Summarise(table), {}, {}};
  content.refusals = Refusals(file, table, content.summary);
  AddLengths(content.summary, table, content.refusals);
  for (const ColumnSummary& column : content.summary.columns)
    content.missing_lines.push_back(column.missing > 0 ? table.line(column.first_missing) : 0);
  return content;
}

std::optional<Described> Describe(const std::filesystem::path& file, Diagnostics& faults) {
  if (!MayBeRecording(file, faults)) return std::nullopt;
  const std::optional<RecordedTable> table = ReadRecordedTable(file, faults);
  if (!table) return std::nullopt;
  switch (LayoutOf(*table)) {
    case Layout::kSteppedSine:
      if (std::optional<FrequencyResponse> response = ReadFrequencyResponse(file, faults))
        return Described{file.string(), *std::move(response)};
      return std::nullopt;
    case Layout::kStatic:
      if (std::optional<std::vector<StaticMeasurement>> loads = ReadStaticLoads(file, faults))
        return Described{file.string(), *std::move(loads)};
      return std::nullopt;
    case Layout::kOverTime: break;
  }
  return Described{file.string(), Look(file, *table)};
}

/// A record may be as uneven as times with few digits are.
constexpr double kUneven = 0.5;

/// What would keep a study from using it, or should be looked at.
std::vector<std::string> Remarks(const ColumnSummary& column, int missing_line) {
  std::vector<std::string> remarks;
  if (column.missing == column.samples) return {"no numbers"};
  if (column.missing > 0)
    remarks.push_back(std::to_string(column.missing) + " missing, first in " +
                      (missing_line > 0 ? "line " + std::to_string(missing_line)
                                        : "sample " + std::to_string(column.first_missing + 1)));
  if (column.unit.empty()) remarks.emplace_back("no unit");
  else if (!column.unit_known) remarks.push_back("unknown unit '" + column.unit + "'");
  if (column.minimum == column.maximum) remarks.emplace_back("constant");
  const auto clipped = [&](std::size_t samples, double at) {
    if (samples > 0) remarks.push_back("clipped: " + std::to_string(samples) + " samples at " + Rounded(at, 4));
  };
  clipped(column.clipped_top, column.maximum);
  clipped(column.clipped_bottom, column.minimum);
  // A level's rounding has the deviation level/sqrt(12).
  if (column.rms > 0 && column.level / std::sqrt(12.0) > 0.05 * column.rms)
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

std::string TextOf(const OverTime& content) {
  TextTable table({"channel", "unit", "minimum", "maximum", "mean", "rms", "level", "remarks"});
  const std::vector<ColumnSummary>& columns = content.summary.columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ColumnSummary& c = columns[i];
    table.Add({c.name, c.unit, Rounded(c.minimum, 4), Rounded(c.maximum, 4), Rounded(c.mean, 4), Rounded(c.rms, 4),
               Rounded(c.level, 2), Joined(Remarks(c, content.missing_lines[i]))});
  }
  std::string refusals;
  for (const std::string& refusal : content.refusals) refusals += "  " + refusal + '\n';
  if (!refusals.empty()) refusals = "a fit refuses this recording:\n" + refusals;
  const std::size_t samples = columns.empty() ? 0 : columns.front().samples;
  return "time history, " + std::to_string(samples) + " samples, " + TimesText(content.summary) + table.Format() +
         "rms: about the mean; level: smallest difference between two values\n" + refusals;
}

/// Root mean square of the deviations over repeats, as shares of the gain; NaN where there are none.
double NoiseOf(const ChannelResponse& channel) {
  double sum = 0;
  for (std::size_t i = 0; i < channel.gain_sd.size(); ++i)
    sum += std::pow(channel.gain_sd[i] / std::abs(channel.response[i]), 2);
  return channel.gain_sd.empty() ? std::nan("") : std::sqrt(sum / static_cast<double>(channel.gain_sd.size()));
}

struct GainRange {
  double least = 0;
  double most = 0;
};

GainRange GainsOf(const ChannelResponse& channel) {
  GainRange range = {std::abs(channel.response.front()), 0};
  for (const std::complex<double>& response : channel.response) {
    range.least = std::min(range.least, std::abs(response));
    range.most = std::max(range.most, std::abs(response));
  }
  return range;
}

/// Accelerations are given relative to that of the post.
std::string GainUnit(const ChannelResponse& channel) {
  return channel.unit == "m/s^2" ? "1" : channel.unit == "m" ? "m/m" : channel.unit + "/m";
}

std::string TextOf(const FrequencyResponse& response) {
  const auto [least, most] = std::minmax_element(response.amplitude_m.begin(), response.amplitude_m.end());
  std::string text = "stepped sine, " + std::to_string(response.frequency_Hz.size()) + " frequencies from " +
                     Rounded(response.frequency_Hz.front(), 4) + " to " + Rounded(response.frequency_Hz.back(), 4) +
                     " Hz, post amplitude " + Rounded(1e3 * *least, 3) + " to " + Rounded(1e3 * *most, 3) + " mm\n";
  TextTable table({"channel", "gain", "minimum", "maximum", "sd of repeats", "mean offset"});
  for (const ChannelResponse& channel : response.channels) {
    const GainRange range = GainsOf(channel);
    const double noise = NoiseOf(channel);
    table.Add({channel.name, GainUnit(channel), Rounded(range.least, 3), Rounded(range.most, 3),
               std::isnan(noise) ? "none" : Rounded(100 * noise, 2) + " %", channel.mean.empty() ? "no" : "yes"});
  }
  return text + table.Format();
}

std::string TextOf(const std::vector<StaticMeasurement>& loads) {
  TextTable table({"quantity", "value", "sd", "unit"});
  for (const StaticMeasurement& load : loads)
    table.Add({load.name, Rounded(load.value, 5), Rounded(load.sd, 3), SiUnit(load.dimension)});
  return "static measurements\n" + table.Format();
}

Json JsonOf(const OverTime& content) {
  Json json = {
      {"kind", "time_history"}, {"time", nullptr}, {"channels", Json::array()}, {"refusals", content.refusals}};
  if (const std::optional<TimeSummary>& time = content.summary.time) {
    Json gaps = Json::array();
    for (const TimeGap& gap : time->gaps)
      gaps.push_back({{"line", gap.line == 0 ? Json() : Json(gap.line)}, {"from_s", gap.from_s}, {"to_s", gap.to_s}});
    json["time"] = {{"column", time->column}, {"start_s", time->start_s},
                    {"end_s", time->end_s},   {"rate_Hz", time->rate_Hz},
                    {"gaps", gaps},           {"unevenness_samples", time->unevenness}};
  }
  for (std::size_t i = 0; i < content.summary.columns.size(); ++i) {
    const ColumnSummary& c = content.summary.columns[i];
    json["channels"].push_back({{"name", c.name},
                                {"unit", c.unit},
                                {"unit_known", c.unit_known},
                                {"samples", c.samples},
                                {"missing", c.missing},
                                {"minimum", c.minimum},
                                {"maximum", c.maximum},
                                {"mean", c.mean},
                                {"rms", c.rms},
                                {"level", c.level},
                                {"clipped_top", c.clipped_top},
                                {"clipped_bottom", c.clipped_bottom},
                                {"remarks", Remarks(c, content.missing_lines[i])}});
  }
  return json;
}

Json JsonOf(const FrequencyResponse& response) {
  Json channels = Json::array();
  for (const ChannelResponse& channel : response.channels) {
    const GainRange range = GainsOf(channel);
    const double noise = NoiseOf(channel);
    channels.push_back({{"name", channel.name},
                        {"gain_unit", GainUnit(channel)},
                        {"least_gain", range.least},
                        {"most_gain", range.most},
                        {"gain_sd_share", std::isnan(noise) ? Json() : Json(noise)},
                        {"has_mean", !channel.mean.empty()}});
  }
  return {{"kind", "stepped_sine"},
          {"frequency_Hz", response.frequency_Hz},
          {"post_amplitude_m", response.amplitude_m},
          {"channels", channels}};
}

Json JsonOf(const std::vector<StaticMeasurement>& loads) {
  Json quantities = Json::array();
  for (const StaticMeasurement& load : loads)
    quantities.push_back(
        {{"name", load.name}, {"value", load.value}, {"sd", load.sd}, {"unit", SiUnit(load.dimension)}});
  return {{"kind", "static"}, {"quantities", quantities}};
}

std::string AllText(const std::vector<Described>& files) {
  std::string text;
  for (const Described& file : files)
    text += (text.empty() ? "" : "\n") + file.file + ": " +
            std::visit([](const auto& content) { return TextOf(content); }, file.content);
  return text;
}

std::string AllJson(const std::vector<Described>& files) {
  Json list = Json::array();
  for (const Described& file : files) {
    Json json = {{"file", file.file}};
    json.update(std::visit([](const auto& content) { return JsonOf(content); }, file.content));
    list.push_back(std::move(json));
  }
  return JsonText(Json{{"files", list}});
}

}  // namespace

int Run(const InfoCommand& command) {
  Diagnostics faults;
  std::vector<Described> files;
  for (const std::filesystem::path& file : command.files)
    if (std::optional<Described> described = Describe(file, faults)) files.push_back(*std::move(described));
  if (!files.empty() && command.json) Print(AllJson(files));
  else if (!files.empty()) PrintText(AllText(files));
  if (faults.HasErrors()) throw FaultyInput(faults);
  return kGood;
}

}  // namespace fourpost
