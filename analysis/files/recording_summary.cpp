#include "analysis/files/recording_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/sample_times.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/dead_signal.h"
#include "analysis/signals/drift.h"
#include "analysis/signals/held_samples.h"
#include "analysis/signals/median.h"
#include "analysis/signals/release_search.h"
#include "analysis/signals/signal_levels.h"
#include "analysis/signals/slow_drift.h"
#include "analysis/text/name_meaning.h"

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

std::vector<double> Times_s(const RecordedTable& table, StatedUnits units, std::size_t column) {
  std::vector<double> times = Values(table, column);
  const std::optional<Unit> unit = ParseRecordedUnit(UnitText(table, units, column));
  for (double& time : times) time *= unit && unit->dimension == kTime ? unit->si : 1;
  return times;
}

std::optional<TimeSummary> SummariseTimes(const RecordedTable& table, StatedUnits units, std::size_t column) {
  const std::vector<double> times = Times_s(table, units, column);
  const bool all = std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  if (times.size() < 2 || !all) return std::nullopt;
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

/// Before which there is a gap.
std::vector<std::size_t> BreaksOf(const std::vector<double>& times_s, const TimeSummary& time) {
  std::vector<std::size_t> breaks;
  for (std::size_t k = 0; k + 1 < times_s.size() && breaks.size() < time.gaps.size(); ++k)
    if (times_s[k] == time.gaps[breaks.size()].from_s && times_s[k + 1] == time.gaps[breaks.size()].to_s)
      breaks.push_back(k + 1);
  return breaks;
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
  summary.slow_drift = SlowDrift(values);
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
                              std::span<const std::size_t> breaks, RestSearch& rest) {
  ColumnSummary summary = {.name = table.names()[column], .unit = UnitText(table, units, column)};
  summary.unit_known = ParseRecordedUnit(summary.unit).has_value();
  std::vector<double> values = Values(table, column);
  summary.samples = values.size();
  if (table.recording() != nullptr) summary.rate_Hz = table.recording()->rate_Hz(column);
  rest.Add(values, summary.rate_Hz > 0 ? summary.rate_Hz : rate_Hz, breaks);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isfinite(values[row])) continue;
    if (summary.missing++ == 0) summary.first_missing = row;
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (!values.empty()) AddExtent(values, summary);
  return summary;
}

std::optional<Dimension> DimensionOf(const ColumnSummary& column) {
  const std::optional<Unit> unit = ParseRecordedUnit(column.unit);
  return unit ? std::optional(unit->dimension) : std::nullopt;
}

/// By its name, which says no other part.
bool MayBePost(const std::string& name) {
  const std::set<std::string> words = MeaningOf(name).words;
  return words.empty() || words.contains("post");
}

/// Takes drifts away that may be how the vehicle moved.
void KeepDriftsOfSensors(std::vector<ColumnSummary>& columns) {
  int steady = 0;
  int drifting = 0;
  for (const ColumnSummary& column : columns)
    if (column.rms > 0 && DimensionOf(column) == kLength) ++(column.slow_drift ? drifting : steady);
  for (ColumnSummary& column : columns) {
    const std::optional<Dimension> dimension = DimensionOf(column);
    const bool is_force = dimension == kForce || dimension == kAcceleration;
    const bool is_sensor = dimension == kLength ? drifting == 1 && steady > 0 && !MayBePost(column.name)
                                                : is_force && drifting == 0 && steady > 0;
    if (!is_sensor) column.slow_drift.reset();
  }
}

/// Of records that fit into memory at once; else empty.
std::vector<std::vector<double>> SignalsOf(const RecordedTable& table, const std::vector<std::size_t>& of,
                                           const std::vector<ColumnSummary>& columns) {
  constexpr std::size_t kMost = 20'000'000;
  std::size_t samples = 0;
  for (const ColumnSummary& column : columns) samples += column.samples;
  if (samples > kMost) return {};
  std::vector<std::vector<double>> signals;
  for (const std::size_t column : of) signals.push_back(Values(table, column));
  return signals;
}

void AddHeld(const std::vector<std::vector<double>>& signals, std::vector<ColumnSummary>& columns) {
  const std::vector<std::vector<HeldSamples>> held = HeldStretches(signals);
  for (std::size_t i = 0; i < held.size(); ++i)
    for (const HeldSamples& one : held[i]) {
      if (columns[i].held == 0) columns[i].first_held = one.first;
      columns[i].held += one.last - one.first + 1;
    }
}

/// By channels of the rate that the column of times has.
std::vector<ReleaseSamples> SearchReleases(const std::vector<std::vector<double>>& signals,
                                           const RecordingSummary& summary, std::size_t samples) {
  std::vector<std::span<const double>> moving;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const std::optional<Dimension> dimension = DimensionOf(summary.columns[i]);
    const bool is_motion = dimension == kLength || dimension == kAcceleration || dimension == kForce;
    if (is_motion && signals[i].size() == samples) moving.emplace_back(signals[i]);
  }
  return ReleasesOf(moving, summary.time->rate_Hz);
}

/// What is let go drifts only as its rests do. `times_s`: of each sample.
void AddReleases(const std::vector<std::vector<double>>& signals, const std::vector<double>& times_s,
                 RecordingSummary& summary) {
  const std::vector<ReleaseSamples> found = SearchReleases(signals, summary, times_s.size());
  if (found.empty()) return;
  std::size_t resting = 0;
  for (const ReleaseSamples& one : found) {
    resting += one.let_go - one.rest_from + one.end - one.rest;
    summary.releases.push_back({times_s[one.rest_from], times_s[one.let_go], times_s[one.rest], times_s[one.end - 1]});
  }
  // A slope over less says nothing of the whole.
  const bool is_enough = 4 * resting > times_s.size();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ColumnSummary& column = summary.columns[i];
    if (signals[i].size() != times_s.size() || column.missing == column.samples) continue;
    for (const ReleaseSamples& one : found) column.above_rest.push_back(StepOf(signals[i], one));
    if (!is_enough) continue;
    column.drift = DriftAtRest(signals[i], found);
    column.slow_drift.reset();
  }
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
  // Across a gap nobody knows whether it rests.
  std::vector<double> times_s;
  if (summary.time && !summary.time->gaps.empty()) times_s = Times_s(table, units, *times);
  const std::vector<std::size_t> breaks = summary.time ? BreaksOf(times_s, *summary.time) : std::vector<std::size_t>();
  std::vector<std::size_t> of;
  for (std::size_t column = 0; column < table.names().size(); ++column) {
    if (column == times || table.HoldsText(column)) continue;
    of.push_back(column);
    summary.columns.push_back(
        SummariseColumn(table, units, column, summary.time ? summary.time->rate_Hz : 0, breaks, rest));
  }
  const std::vector<std::vector<double>> signals = SignalsOf(table, of, summary.columns);
  AddHeld(signals, summary.columns);
  KeepDriftsOfSensors(summary.columns);
  if (summary.time) AddReleases(signals, Times_s(table, units, *times), summary);
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
  // Samples that were lost take their time.
  const auto time_of = [&](double by_samples_s) {
    const auto sample = static_cast<std::size_t>(std::round(by_samples_s * summary.time->rate_Hz));
    return times_s[std::min(sample, times_s.size() - 1)] - times_s.front();
  };
  if (summary.rest && !times_s.empty()) summary.rest = {time_of(summary.rest->from_s), time_of(summary.rest->to_s)};
  return summary;
}

}  // namespace fourpost
