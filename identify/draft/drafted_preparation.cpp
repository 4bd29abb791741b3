#include "identify/draft/drafted_preparation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/signals/motionless.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

/// Rows from the first on to before the last.
using Rows = std::pair<std::size_t, std::size_t>;

/// Runs of samples without a number.
void AddMissing(const RecordedTable& table, std::size_t column, std::vector<Rows>& runs) {
  std::size_t first = 0;
  for (std::size_t row = 0; row < table.rows(column); ++row) {
    const std::optional<double> number = table.Number(row, column);
    if (!number || !std::isfinite(*number)) continue;
    if (row > first) runs.emplace_back(first, row);
    first = row + 1;
  }
  if (table.rows(column) > first) runs.emplace_back(first, table.rows(column));
}

/// Those that overlap or adjoin as one.
std::size_t DistinctCount(std::vector<Rows> runs) {
  std::sort(runs.begin(), runs.end());
  std::size_t count = 0;
  std::size_t end = 0;
  for (const auto& [first, last] : runs) {
    if (count == 0 || first > end) ++count;
    end = std::max(end, last);
  }
  return count;
}

/// The longest gap, of rows or of fields; `count`: how many stretches of the recording lack something.
double LongestGap(const RecordedTable& table, const RecordingSummary& summary, std::size_t& count) {
  double longest_s = 0;
  for (const TimeGap& gap : summary.time->gaps) longest_s = std::max(longest_s, gap.to_s - gap.from_s);
  std::vector<Rows> runs;
  for (const ColumnSummary& column : summary.columns)
    if (column.missing > 0 && column.missing < column.samples && column.unit_known)
      AddMissing(table, *table.FindColumn(column.name), runs);
  for (const auto& [first, last] : runs)
    longest_s = std::max(longest_s, static_cast<double>(last - first + 1) / summary.time->rate_Hz);
  count = summary.time->gaps.size() + DistinctCount(runs);
  return longest_s;
}

/// In SI, which `noise` of a study takes; g may be read as grams there.
std::string UnitOfNoise(const Dimension& dimension) { return dimension == kLength ? "mm" : SiUnit(dimension); }

/// Of a grid, 50 or 60 Hz, or a harmonic of it that a line is at; lines are known to half a step of their spectrum.
std::optional<int> MainsOf(const SensorNoise& noise) {
  constexpr double kNear_Hz = 1.5;
  constexpr double kHighest = 10;
  for (const int mains_Hz : {50, 60}) {
    const double order = std::round(noise.line_Hz.value_or(0) / mains_Hz);
    if (order >= 1 && order <= kHighest && std::abs(*noise.line_Hz - order * mains_Hz) < kNear_Hz) return mains_Hz;
  }
  return std::nullopt;
}

/// In the channels of a recording that were matched.
std::set<int> HumOf(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches) {
  std::set<int> mains_Hz;
  for (const ChannelMatch& match : matches)
    for (const SourceChannel& channel : match.source.channels)
      if (const ColumnSummary* const column = preparation.Find(channel.name); column != nullptr && column->noise)
        if (const std::optional<int> one = MainsOf(*column->noise)) mains_Hz.insert(*one);
  return mains_Hz;
}

/// White but for hum, which may be too weak in a channel for a line: a vehicle that moves would do so below it.
bool IsOfRest(const SensorNoise& noise, const std::set<int>& hum_Hz) {
  return noise.is_white || MainsOf(noise) || (!hum_Hz.empty() && noise.below_Hz > *hum_Hz.rbegin());
}

/// "; hum of 50 Hz"
std::string HumText(const std::set<int>& mains_Hz) {
  std::string text;
  for (const int one_Hz : mains_Hz) text += (text.empty() ? "; hum of " : " and ") + std::to_string(one_Hz) + " Hz";
  return text;
}

}  // namespace

const ColumnSummary* DraftedPreparation::Find(const std::string& channel) const {
  const auto found = std::find_if(summary.columns.begin(), summary.columns.end(),
                                  [&](const ColumnSummary& column) { return column.name == channel; });
  return found == summary.columns.end() ? nullptr : &*found;
}

DraftedPreparation PreparationOf(const RecordedTable& table, std::span<const std::string> units) {
  DraftedPreparation preparation{.times = {}, .summary = Summarise(table, units)};
  if (!preparation.summary.time) return preparation;
  const TimeSummary& time = *preparation.summary.time;
  // Beyond what a reader takes as even.
  constexpr double kJitter = 0.01;
  if (time.jitter > kJitter) {
    preparation.times.rate_Hz = std::round(1e3 * time.rate_Hz) / 1e3;
    preparation.why_resampled = "steps differ by " + Rounded(100 * time.jitter, 2) + " % rms";
  }
  std::size_t count = 0;
  const double longest_s = LongestGap(table, preparation.summary, count);
  if (longest_s > 0) preparation.over_all_gaps_s = 1e-3 * std::ceil(1.05e3 * longest_s);
  if (longest_s > 0 && longest_s <= kLongestBridge_s) {
    preparation.times.bridge_s = preparation.over_all_gaps_s;
    preparation.why_bridged = std::to_string(count) + (count == 1 ? " gap" : " gaps") + ", the longest " +
                              Rounded(1e3 * longest_s, 2) + " ms";
  }
  return preparation;
}

bool Drifts(const ColumnSummary& column) {
  // A straight line has a rise of 3.5 rms; a motion of few periods has a slope of its own.
  constexpr double kDrifts = 1.7;
  return column.rms > 0 && std::abs(column.drift) > kDrifts * column.rms;
}

void RemoveDrifts(const DraftedPreparation& preparation, ChannelMatch& match) {
  for (SourceChannel& channel : match.source.channels)
    if (const ColumnSummary* const column = preparation.Find(channel.name); column != nullptr && Drifts(*column))
      channel.has_trend = true;
}

bool IsMotionless(const DraftedPreparation& preparation, const ChannelSource& source) {
  const auto is_still = [&](const SourceChannel& channel) {
    const ColumnSummary* const found = preparation.Find(channel.name);
    if (found == nullptr) return false;
    double largest = 0;
    for (const ColumnSummary& other : preparation.summary.columns)
      if (other.unit == found->unit) largest = std::max(largest, other.rms);
    return found->rms < kMotionlessShare * largest;
  };
  return std::all_of(source.channels.begin(), source.channels.end(), is_still);
}

std::string TimesLines(const DraftedPreparation& preparation, const std::vector<std::string>& others) {
  std::string lines;
  const std::optional<TimeSummary>& time = preparation.summary.time;
  const auto is_usual = [](const std::string& name) {
    return std::find(kTimeColumn.names.begin(), kTimeColumn.names.end(), name) != kTimeColumn.names.end();
  };
  if (time && (!preparation.time_unit.empty() || !is_usual(time->column))) {
    SourceChannel column(time->column);
    column.unit = preparation.time_unit;
    lines += "    time: " + SourceText({.channels = {column}});
    if (preparation.is_time_unit_guessed || time->is_guessed) lines += "  # look at: ";
    if (time->is_guessed) lines += preparation.is_time_unit_guessed ? "it rises evenly; " : "it rises evenly";
    lines += preparation.is_time_unit_guessed ? "its unit is a guess\n" : "\n";
  }
  if (preparation.times.rate_Hz)
    lines += "    resample: " + FormatNumber(*preparation.times.rate_Hz) + " Hz  # " + preparation.why_resampled + '\n';
  if (preparation.times.bridge_s > 0)
    lines += "    bridge: " + FormatNumber(std::round(1e3 * preparation.times.bridge_s)) + " ms  # " +
             preparation.why_bridged + '\n';
  std::string list;
  for (const std::string& other : others) list += (list.empty() ? "" : ", ") + other;
  if (!list.empty()) lines += "    with: [" + list + "]  # " + preparation.why_beside + '\n';
  return lines;
}

std::string NoiseLines(const DraftedPreparation& preparation, const std::vector<ChannelMatch>& matches) {
  if (!preparation.summary.rest) return "";
  std::string lines;
  const std::set<int> hum_Hz = HumOf(preparation, matches);
  for (const ChannelMatch& match : matches) {
    double sum = 0;
    bool is_of_rest = true;
    std::optional<Unit> unit;
    for (const SourceChannel& channel : match.source.channels) {
      const ColumnSummary* const column = preparation.Find(channel.name);
      unit = column == nullptr ? std::nullopt : ParseRecordedUnit(channel.unit.empty() ? column->unit : channel.unit);
      if (!unit || !column->noise || !(column->noise->sd > 0)) {
        sum = 0;
        break;
      }
      sum += std::pow(column->noise->sd * unit->si * channel.factor, 2);
      is_of_rest = is_of_rest && IsOfRest(*column->noise, hum_Hz);
    }
    if (!(sum > 0)) continue;
    const bool is_mean = match.source.combine == ChannelSource::Combine::kMean;
    const std::string name = UnitOfNoise(unit->dimension);
    const double sd = std::sqrt(sum) / (is_mean ? static_cast<double>(match.source.channels.size()) : 1.0);
    lines += "      " + match.name + ": " + ShortNumber(sd / ParseUnit(name)->si, 3) + " " + name +
             (is_of_rest ? "\n" : "  # look at: not white, was the vehicle at rest?\n");
  }
  if (lines.empty()) return "";
  const RestTime& rest = *preparation.summary.rest;
  return "    noise:  # standard deviations at rest, from " + Rounded(rest.from_s, 3) + " to " + Rounded(rest.to_s, 3) +
         " s after the first sample" + HumText(hum_Hz) + "\n" + lines;
}

}  // namespace fourpost
