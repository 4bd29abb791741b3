#include "analysis/files/recording_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/sample_times.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/dead_signal.h"
#include "analysis/signals/drift.h"
#include "analysis/signals/median.h"
#include "analysis/signals/signal_levels.h"

namespace fourpost {
namespace {

/// Of the levels of a channel, its rms where it moves.
constexpr double kMoving = 20;

/// NaN for what is no finite number.
std::vector<double> Values(const RecordedTable& table, std::size_t column) {
  if (table.recording() != nullptr) return table.recording()->Recorded(column);
  std::vector<double> values(table.rows(column));
  for (std::size_t row = 0; row < values.size(); ++row)
    values[row] = table.Number(row, column).value_or(std::numeric_limits<double>::quiet_NaN());
  return values;
}

/// Steps of a half to one and a half times the mean one.
bool RisesEvenly(const RecordedTable& table, std::size_t column) {
  if (table.HoldsText(column) || table.rows(column) < 4) return false;
  const std::vector<double> values = Values(table, column);
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(std::abs(values[k] - values[k - 1] - step) < 0.5 * step)) return false;
  return true;
}

std::optional<std::size_t> GuessedTimes(const RecordedTable& table) {
  std::optional<std::size_t> guessed;
  for (std::size_t column = 0; column < table.names().size(); ++column) {
    if (!table.unit(column).empty() || !RisesEvenly(table, column)) continue;
    // Of copies one will do.
    if (guessed && Values(table, column) != Values(table, *guessed)) return std::nullopt;
    if (!guessed) guessed = column;
  }
  return guessed;
}

std::optional<std::size_t> TimesOf(const RecordedTable& table) {
  for (const std::string& name : kTimeColumn.names)
    if (const std::optional<std::size_t> column = table.FindColumn(name)) return column;
  for (std::size_t column = 0; column < table.names().size(); ++column)
    if (const std::optional<Unit> unit = ParseRecordedUnit(table.unit(column)); unit && unit->dimension == kTime)
      return column;
  return GuessedTimes(table);
}

bool IsNamedAsTimes(const std::string& name) {
  return std::find(kTimeColumn.names.begin(), kTimeColumn.names.end(), name) != kTimeColumn.names.end();
}

double Unevenness(const std::vector<double>& times) {
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  double worst = 0;
  for (std::size_t k = 0; k < times.size(); ++k)
    worst = std::max(worst, std::abs(times[k] - times.front() - step * static_cast<double>(k)));
  return worst / step;
}

/// Rms of the steps that are no gaps about the usual one, as a share of it; 0 where rounding of the times explains it.
double JitterOf(const std::vector<double>& steps, double usual) {
  double squares = 0;
  double count = 0;
  for (const double step : steps) {
    if (std::abs(step - usual) >= 0.5 * usual) continue;
    squares += std::pow(step / usual - 1, 2);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

using StatedUnits = std::span<const std::string>;

/// As stated, else as the file has it.
std::string UnitText(const RecordedTable& table, StatedUnits units, std::size_t column) {
  return column < units.size() && !units[column].empty() ? units[column] : table.unit(column);
}

std::optional<TimeSummary> SummariseTimes(const RecordedTable& table, StatedUnits units, std::size_t column) {
  std::vector<double> times = Values(table, column);
  const std::optional<Unit> unit = ParseRecordedUnit(UnitText(table, units, column));
  const bool all = std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  if (times.size() < 2 || !all) return std::nullopt;
  for (double& time : times) time *= unit && unit->dimension == kTime ? unit->si : 1;
  std::vector<double> steps(times.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = times[k + 1] - times[k];
  const double usual = UsualStep(steps);
  if (!(usual > 0)) return std::nullopt;
  TimeSummary summary = {.column = table.names()[column], .start_s = times.front(), .end_s = times.back()};
  summary.rate_Hz = 1 / usual;
  for (std::size_t k = 0; k < steps.size(); ++k)
    // As ReadTimeRecording has it.
    if (std::abs(steps[k] - usual) >= 0.5 * usual) summary.gaps.push_back({table.line(k + 1), times[k], times[k + 1]});
  if (!summary.gaps.empty()) {
    summary.jitter = JitterOf(steps, usual);
    return summary;
  }
  summary.rate_Hz = static_cast<double>(steps.size()) / (times.back() - times.front());
  summary.unevenness = Unevenness(times);
  // Times of few digits, or of single precision, are uneven by their rounding alone.
  const double rounding_s = std::max(LevelOf(steps), 0x1p-23 * std::abs(times.back()));
  if (summary.unevenness / summary.rate_Hz <= 1.01 * rounding_s) return summary;
  summary.jitter = JitterOf(steps, usual);
  return summary;
}

/// Samples, the last excluded.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  /// From the begin of the record.
  double start_s = 0;
};

/// The longest without a gap.
Stretch LongestStretch(const RecordedTable& table, StatedUnits units, std::size_t column, const TimeSummary& time) {
  const std::vector<double> times = Values(table, column);
  const std::optional<Unit> unit = ParseRecordedUnit(UnitText(table, units, column));
  const double si = unit && unit->dimension == kTime ? unit->si : 1;
  Stretch longest;
  std::size_t first = 0;
  std::size_t gap = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const bool ends = k + 1 == times.size() || (gap < time.gaps.size() && times[k] * si == time.gaps[gap].from_s);
    if (!ends) continue;
    ++gap;
    if (k + 1 - first > longest.last - longest.first) longest = {first, k + 1, (times[first] - times.front()) * si};
    first = k + 1;
  }
  return longest;
}

void AddExtent(const std::vector<double>& values, ColumnSummary& summary) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  summary.minimum = *least;
  summary.maximum = *most;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) summary.mean += value;
  summary.mean /= count;
  double squares = 0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.rms = std::sqrt(squares / count);
  const TrendLine trend = TrendOf(values);
  summary.drift = trend.last - trend.first;
  summary.level = LevelOf(values);
  summary.is_dead = IsDead(values);
  const std::size_t top = ClippedAtTop(values, summary.level);
  const std::size_t bottom = ClippedAtBottom(values, summary.level);
  if (top + bottom < kFewestClipped) return;
  summary.clipped_top = top;
  summary.clipped_bottom = bottom;
}

/// `rate_Hz`: where the channel has none of its own.
ColumnSummary SummariseColumn(const RecordedTable& table, StatedUnits units, std::size_t column, double rate_Hz,
                              const std::optional<Stretch>& stretch, RestSearch& rest) {
  ColumnSummary summary = {.name = table.names()[column], .unit = UnitText(table, units, column)};
  summary.unit_known = ParseRecordedUnit(summary.unit).has_value();
  std::vector<double> values = Values(table, column);
  summary.samples = values.size();
  if (table.recording() != nullptr) summary.rate_Hz = table.recording()->rate_Hz(column);
  const bool is_cut = stretch && stretch->last <= values.size();
  rest.Add(is_cut ? std::span<const double>(values).subspan(stretch->first, stretch->last - stretch->first) : values,
           summary.rate_Hz > 0 ? summary.rate_Hz : rate_Hz);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isfinite(values[row])) continue;
    if (summary.missing++ == 0) summary.first_missing = row;
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (!values.empty()) AddExtent(values, summary);
  return summary;
}

}  // namespace

std::string TimesColumn(const RecordedTable& table) {
  const std::optional<std::size_t> column = TimesOf(table);
  return column ? table.names()[*column] : "";
}

RecordingSummary Summarise(const RecordedTable& table, StatedUnits units) {
  RecordingSummary summary;
  RestSearch rest;
  const std::optional<std::size_t> times = TimesOf(table);
  if (times) summary.time = SummariseTimes(table, units, *times);
  if (summary.time)
    summary.time->is_guessed =
        !IsNamedAsTimes(table.names()[*times]) && !ParseRecordedUnit(UnitText(table, units, *times));
  // Across a gap nobody knows when.
  std::optional<Stretch> stretch;
  if (summary.time && !summary.time->gaps.empty()) stretch = LongestStretch(table, units, *times, *summary.time);
  for (std::size_t column = 0; column < table.names().size(); ++column)
    if (column != times && !table.HoldsText(column))
      summary.columns.push_back(
          SummariseColumn(table, units, column, summary.time ? summary.time->rate_Hz : 0, stretch, rest));
  // Where all are at rest none is dead.
  const auto moves = [](const ColumnSummary& one) {
    return one.unit_known && one.level > 0 && one.rms > kMoving * one.level;
  };
  if (std::none_of(summary.columns.begin(), summary.columns.end(), moves))
    for (ColumnSummary& one : summary.columns) one.is_dead = false;
  if (!summary.time) return summary;
  summary.rest = rest.Longest();
  constexpr std::size_t kFewest = 64;
  for (std::size_t i = 0; summary.rest && i < summary.columns.size(); ++i)
    if (const std::vector<double> samples = rest.Samples(i, *summary.rest); samples.size() >= kFewest)
      summary.columns[i].noise = SensorNoiseOf(samples, rest.rate_Hz(i));
  if (summary.rest && stretch) {
    summary.rest->from_s += stretch->start_s;
    summary.rest->to_s += stretch->start_s;
  }
  return summary;
}

}  // namespace fourpost
