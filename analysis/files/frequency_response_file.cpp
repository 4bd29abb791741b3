#include "analysis/files/frequency_response_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording_layout.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/number.h"
#include "analysis/text/unit_spelling.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

constexpr std::string_view kAmplitude = "post_amplitude_m";
/// The first may be stated elsewhere.
constexpr std::array<std::string_view, 5> kRequired = {kAmplitude, "frequency_Hz", "channel", "gain", "phase_deg"};
constexpr std::array<std::string_view, 7> kOptional = {"gain_sd",         "phase_sd_deg", "mean",    "mean_sd",
                                                       "second_harmonic", "unit",         kAmplitude};

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

enum class Sign { kAny, kNotNegative, kPositive };

struct PrefixUnit {
  std::string_view prefix;
  std::string_view unit;
};
constexpr std::array<PrefixUnit, 3> kPrefixUnits = {{{"a_", "m/s^2"}, {"s_", "m"}, {"F_", "N"}}};

struct ChannelRows {
  std::string name;
  std::vector<std::size_t> rows;
};

/// What the rows of one frequency have in common.
struct Point {
  double amplitude_m = 0;
  std::size_t first_row = 0;
  std::set<std::string> channels;
};

/// A blank, and what other programs write for no number.
bool IsMissing(const std::string& text) { return text.empty() || text == "NaN" || text == "nan" || text == "NAN"; }

bool HasSign(double number, Sign sign) {
  if (sign == Sign::kPositive) return number > 0;
  return sign == Sign::kAny || number >= 0;
}

/// "rad/s" or "deg/s", but not "Hz", though angles have no dimension: a gyro counts no cycles.
bool IsAngularVelocity(const Unit& unit, std::string_view text) {
  return unit.dimension == kFrequency && (text.starts_with("rad") || text.starts_with("deg"));
}

bool IsChannelUnit(const std::optional<Unit>& unit, std::string_view text) {
  return unit && (unit->dimension == kLength || unit->dimension == kForce || unit->dimension == kAcceleration ||
                  IsAngularVelocity(*unit, text));
}

std::string ChannelUnit(const Dimension& dimension) { return dimension == kFrequency ? "rad/s" : SiUnit(dimension); }

void Scale(double factor, std::vector<double>& values) {
  for (double& value : values) value *= factor;
}

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class FrequencyResponseReader {
 public:
  FrequencyResponseReader(const RecordedTable& table, std::optional<double> amplitude_m, Diagnostics& diagnostics)
      : table_(table), amplitude_m_(amplitude_m), diagnostics_(diagnostics) {}

  std::optional<FrequencyResponse> Read() {
    for (std::size_t row = 0; row < table_.rows(0); ++row) AddRow(row);
    // A row that could not be placed would be reported as missing once more.
    if (good_) CheckComplete();
    FrequencyResponse response;
    for (const auto& [frequency_Hz, point] : points_) {
      response.frequency_Hz.push_back(frequency_Hz);
      response.amplitude_m.push_back(point.amplitude_m);
    }
    for (const ChannelRows& channel : channels_) response.channels.push_back(ReadChannel(channel));
    if (!good_) return std::nullopt;
    return response;
  }

 private:
  void Fault(const Finding& kind, std::size_t row, const std::vector<std::string>& words = {}) {
    table_.Report(kind, row, words, diagnostics_);
    good_ = false;
  }

  std::string Text(std::size_t row, std::string_view column) const {
    return table_.Text(row, *table_.FindColumn(column));
  }

  std::optional<double> Number(std::size_t row, std::string_view column) const {
    return table_.Number(row, *table_.FindColumn(column));
  }

  /// "a_cg at 3.2 Hz".
  std::string PointOf(std::size_t row) const {
    return Text(row, "channel") + " at " + Text(row, "frequency_Hz") + " Hz";
  }

  /// NaN, and reported, unless the field is a number of this sign.
  double ReadNumber(std::size_t row, std::string_view column, Sign sign) {
    const std::string text = Text(row, column);
    const std::string field(column);
    const std::optional<double> number = Number(row, column);
    if (IsMissing(text)) Fault(kFieldMissing, row, {PointOf(row), field});
    else if (!number) Fault(kFieldNotANumber, row, {PointOf(row), field, text});
    else if (!HasSign(*number, sign))
      Fault(sign == Sign::kPositive ? kFieldNotPositive : kFieldNegative, row, {PointOf(row), field, text});
    else return *number;
    return kNaN;
  }

  void AddRow(std::size_t row) {
    const std::string name = Text(row, "channel");
    const double frequency_Hz = ReadNumber(row, "frequency_Hz", Sign::kPositive);
    const double amplitude_m =
        table_.FindColumn(kAmplitude) ? ReadNumber(row, kAmplitude, Sign::kPositive) : *amplitude_m_;
    if (name.empty()) return Fault(kChannelNameless, row);
    ChannelRows& channel = FindChannel(name);
    if (!std::isnan(frequency_Hz)) AddToPoint(row, frequency_Hz, amplitude_m, channel);
    channel.rows.push_back(row);
  }

  ChannelRows& FindChannel(const std::string& name) {
    const auto found =
        std::find_if(channels_.begin(), channels_.end(), [&](const ChannelRows& other) { return other.name == name; });
    return found == channels_.end() ? channels_.emplace_back(ChannelRows{name, {}}) : *found;
  }

  /// `channel` has the rows before this one.
  void AddToPoint(std::size_t row, double frequency_Hz, double amplitude_m, const ChannelRows& channel) {
    Point& point = points_.emplace(frequency_Hz, Point{amplitude_m, row, {}}).first->second;
    if (amplitude_m != point.amplitude_m && !std::isnan(amplitude_m) && !std::isnan(point.amplitude_m))
      Fault(
          kAmplitudesDiffer, row,
          {PointOf(row), Text(row, kAmplitude), Text(point.first_row, kAmplitude), table_.RowInWords(point.first_row)});
    if (!point.channels.insert(channel.name).second) return Fault(kChannelTwice, row, {PointOf(row)});
    const std::optional<double> before =
        channel.rows.empty() ? std::nullopt : Number(channel.rows.back(), "frequency_Hz");
    if (before && *before > frequency_Hz)
      Fault(kFrequenciesUnsorted, row, {PointOf(row), Text(channel.rows.back(), "frequency_Hz") + " Hz"});
  }

  void CheckComplete() {
    for (const auto& [frequency_Hz, point] : points_) {
      std::vector<std::string> missing;
      for (const ChannelRows& channel : channels_)
        if (!point.channels.contains(channel.name)) missing.push_back(channel.name);
      if (!missing.empty())
        Fault(kChannelsMissing, point.first_row, {FormatNumber(frequency_Hz) + " Hz", Join(missing)});
    }
  }

  ChannelResponse ReadChannel(const ChannelRows& channel) {
    ChannelResponse out;
    out.name = channel.name;
    for (const std::size_t row : channel.rows) out.response.push_back(ReadResponse(row));
    out.gain_sd = ReadOptional(channel, "gain_sd", Sign::kNotNegative);
    out.phase_sd_rad = ReadOptional(channel, "phase_sd_deg", Sign::kNotNegative);
    Scale(RadiansFromDegrees(1), out.phase_sd_rad);
    out.mean = ReadOptional(channel, "mean", Sign::kAny);
    out.mean_sd = ReadOptional(channel, "mean_sd", Sign::kNotNegative);
    if (out.mean.empty() && !out.mean_sd.empty())
      Fault(kMeanSdWithoutMean, channel.rows.front(), {channel.name, table_.file()});
    out.second_harmonic = ReadOptional(channel, "second_harmonic", Sign::kNotNegative);
    ToSi(ReadUnit(channel), out);
    return out;
  }

  std::complex<double> ReadResponse(std::size_t row) {
    const double gain = ReadNumber(row, "gain", Sign::kPositive);
    const double phase_deg = ReadNumber(row, "phase_deg", Sign::kAny);
    // std::polar is undefined for a NaN gain.
    return std::isnan(gain) ? gain : std::polar(gain, RadiansFromDegrees(phase_deg));
  }

  /// Empty when the channel has nothing in this column.
  std::vector<double> ReadOptional(const ChannelRows& channel, std::string_view column, Sign sign) {
    std::vector<double> values;
    const auto is_blank = [&](std::size_t row) { return IsMissing(Text(row, column)); };
    if (!table_.FindColumn(column) || std::all_of(channel.rows.begin(), channel.rows.end(), is_blank)) return values;
    // A column of the wrong sign is one fault.
    bool is_negative = false;
    for (const std::size_t row : channel.rows) {
      const std::optional<double> number = Number(row, column);
      const bool has_wrong_sign = number && !HasSign(*number, sign);
      if (is_blank(row)) Fault(kFieldNotEverywhere, row, {PointOf(row), std::string(column)});
      else if (!has_wrong_sign || !is_negative) values.push_back(ReadNumber(row, column, sign));
      is_negative = is_negative || has_wrong_sign;
    }
    return values;
  }

  Unit ReadUnit(const ChannelRows& channel) {
    const std::string text = UnitText(channel);
    const std::optional<Unit> unit = ParseUnit(text);
    if (IsChannelUnit(unit, text)) return *unit;
    if (table_.FindColumn("unit")) Fault(kChannelUnit, channel.rows.front(), {channel.name, text, UnitHint(text)});
    else Fault(kChannelUnitUnknown, channel.rows.front(), {channel.name});
    return {};
  }

  /// Empty when it is unknown.
  std::string UnitText(const ChannelRows& channel) {
    if (table_.FindColumn("unit")) return UnitInColumn(channel);
    for (const PrefixUnit& rule : kPrefixUnits)
      if (channel.name.starts_with(rule.prefix)) return std::string(rule.unit);
    return {};
  }

  std::string UnitInColumn(const ChannelRows& channel) {
    const std::string first = Text(channel.rows.front(), "unit");
    for (const std::size_t row : channel.rows)
      if (Text(row, "unit") != first)
        Fault(kChannelUnitsDiffer, row,
              {PointOf(row), Text(row, "unit"), first, table_.RowInWords(channel.rows.front())});
    return first;
  }

  static void ToSi(const Unit& unit, ChannelResponse& channel) {
    channel.unit = ChannelUnit(unit.dimension);
    Scale(unit.si, channel.mean);
    Scale(unit.si, channel.mean_sd);
    Scale(unit.si, channel.second_harmonic);
    // Accelerations are relative to that of the post.
    if (unit.dimension == kAcceleration) return;
    Scale(unit.si, channel.gain_sd);
    for (std::complex<double>& response : channel.response) response *= unit.si;
  }

  const RecordedTable& table_;
  std::optional<double> amplitude_m_;
  Diagnostics& diagnostics_;
  std::map<double, Point> points_;
  /// In the order of the file.
  std::vector<ChannelRows> channels_;
  bool good_ = true;
};

/// What a fit writes: several recordings, each measured and modelled. Its columns are no slips of one who wrote them.
bool IsComparison(const RecordedTable& table) {
  return table.FindColumn("gain_measured") && table.FindColumn("gain_modelled");
}

/// "bounce, pitch"
std::string RecordingsIn(const RecordedTable& table) {
  const std::optional<std::size_t> column = table.FindColumn("recording");
  std::vector<std::string> names;
  for (std::size_t row = 0; column && row < table.rows(*column); ++row)
    if (names.empty() || names.back() != table.Text(row, *column)) names.push_back(table.Text(row, *column));
  return Join(names);
}

}  // namespace

std::optional<FrequencyResponse> ReadFrequencyResponse(const std::filesystem::path& file, Diagnostics& diagnostics,
                                                       std::optional<double> amplitude_m) {
  const std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics, CsvHeader::kNames);
  if (table && IsComparison(*table)) {
    diagnostics.Report(kComparisonAsRecording, {table->file(), 1}, {RecordingsIn(*table)});
    return std::nullopt;
  }
  if (table && IsTimeHistory(*table)) {
    diagnostics.Report(kHistoryAsSteppedSine, {table->file(), table->names_line()});
    return std::nullopt;
  }
  if (!table) return std::nullopt;
  if (!table->has_names()) {
    diagnostics.Report(kSteppedSineNameless, {table->file(), table->names_line()});
    return std::nullopt;
  }
  // Text files have a column for it.
  if (!amplitude_m && !table->FindColumn(kAmplitude) && table->names_line() == 0 && IsSteppedSine(*table)) {
    diagnostics.Report(kAmplitudeMissing, {table->file()});
    return std::nullopt;
  }
  const std::span<const std::string_view> required(kRequired.begin() + (amplitude_m ? 1 : 0), kRequired.end());
  if (!table->CheckColumns(required, kOptional, diagnostics)) return std::nullopt;
  return FrequencyResponseReader(*table, amplitude_m, diagnostics).Read();
}

}  // namespace fourpost
