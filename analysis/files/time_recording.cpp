#include "analysis/files/time_recording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "analysis/files/bridged_samples.h"
#include "analysis/files/findings.h"
#include "analysis/files/held_channels.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_layout.h"
#include "analysis/files/sample_times.h"
#include "analysis/signals/drift.h"
#include "analysis/signals/median.h"
#include "analysis/signals/spline_through.h"
#include "analysis/signals/uneven_samples.h"
#include "analysis/text/counted.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// What was measured at each sample comes `delay_s` later in the values.
std::vector<double> Advanced(const std::vector<double>& values, double step_s, double delay_s) {
  const UniformSpline spline = SplineThrough(values, 0, step_s);
  std::vector<double> advanced(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    advanced[k] = spline.At(step_s * static_cast<double>(k) + delay_s).value;
  return advanced;
}

/// Reads one file; remembers whether all was well.
class RecordReader {
 public:
  RecordReader(const RecordedTable& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

  std::optional<TimeRecording> Read(std::span<const RecordedChannel> wanted, const RecordedChannel& time,
                                    const TimePreparation& preparation) {
    const std::vector<double> times = Column(time);
    times_good_ = good_;
    may_miss_ = preparation.IsGridded();
    TimeRecording recording;
    std::vector<std::size_t> lengths;
    for (const RecordedChannel& channel : wanted) {
      recording.channels.push_back(Column(channel));
      lengths.push_back(recording.channels.back().size());
    }
    recording.gaps.resize(wanted.size());
    held_.resize(wanted.size());
    if (good_) held_ = LeaveOutHeld(table_, wanted, times, recording.channels, diagnostics_);
    if (preparation.IsGridded()) PutOnGrid(wanted, times, lengths, preparation, recording);
    else recording.step_s = CheckTimes(wanted, times, lengths);
    if (!good_) return std::nullopt;
    if (!preparation.IsGridded()) {
      recording.start_s = times.front();
      recording.end_s = times.back();
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (!held_[i].empty()) BridgeMissing(times, recording.channels[i]);
      recording.gaps = held_;
      ReportBridged(recording);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) Prepare(wanted[i], recording.channels[i], recording);
    if (!good_) return std::nullopt;
    TakeDelaysBack(wanted, recording);
    if (!good_) return std::nullopt;
    return recording;
  }

  /// Keeps no channel.
  void Check(std::span<const RecordedChannel> wanted, const RecordedChannel& time) {
    const std::vector<double> times = Column(time);
    times_good_ = good_;
    std::vector<std::size_t> lengths;
    for (const RecordedChannel& channel : wanted) lengths.push_back(Column(channel).size());
    CheckTimes(wanted, times, lengths);
  }

 private:
  /// Their step; 0 for times that were no numbers, which have been reported.
  double CheckTimes(std::span<const RecordedChannel> wanted, const std::vector<double>& times,
                    const std::vector<std::size_t>& lengths) {
    if (!times_good_) return 0;
    const std::optional<double> step = EvenStepOf(table_, times, diagnostics_);
    good_ = good_ && step;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (lengths[i] > 0 && lengths[i] != times.size())
        Fault(kSamplesDiffer, 0, {wanted[i].names.front(), std::to_string(lengths[i]), std::to_string(times.size())});
    return step.value_or(0);
  }

  void Fault(const Finding& kind, int line, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(kind, {table_.file(), line}, words);
    good_ = false;
  }

  /// SI; empty where the column is not there.
  std::vector<double> Column(const RecordedChannel& channel) {
    for (const std::string& name : channel.names)
      if (const std::optional<std::size_t> column = table_.FindColumn(name)) return Values(*column, channel);
    const std::string& name = channel.names.front();
    Fault(kChannelColumnMissing, table_.names_line(), {name, channel.what, DidYouMean(name, Measuring(channel))});
    return {};
  }

  /// Columns that could be the one wanted: of its dimension.
  std::vector<std::string> Measuring(const RecordedChannel& channel) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < table_.names().size(); ++i)
      if (const std::optional<Unit> unit = ParseRecordedUnit(table_.unit(i));
          unit && unit->dimension == channel.dimension)
        names.push_back(table_.names()[i]);
    return names;
  }

  std::vector<double> Values(std::size_t column, const RecordedChannel& channel) {
    const double unit = UnitOf(column, channel);
    const double si = unit * channel.factor;
    const double offset = channel.offset ? channel.offset->si / unit : 0;
    if (channel.offset && !(channel.offset->unit.dimension == DimensionOf(column, channel)))
      Fault(kOffsetDimension, table_.units_line(),
            {channel.names.front(), DimensionName(channel.offset->unit.dimension)});
    if (table_.recording() != nullptr)
      if (std::optional<std::vector<double>> values = Finite(table_.recording()->Column(column), offset, si))
        return *values;
    std::vector<double> values(table_.rows(column), std::numeric_limits<double>::quiet_NaN());
    int found = 0;
    for (std::size_t row = 0; row < values.size() && found < kMostSampleFaults; ++row) {
      const std::optional<double> number = table_.Number(row, column);
      if (number && std::isfinite(*number)) {
        values[row] = (*number - offset) * si;
        continue;
      }
      if (may_miss_ && (number || table_.Text(row, column).empty())) continue;
      ++found;
      const std::string text = table_.Text(row, column);
      Fault(kSampleMissing, table_.line(row),
            {table_.names()[column], text.empty() ? "no number" : "'" + text + "'", Where(row)});
    }
    return values;
  }

  /// The values in SI; nothing where one is not finite.
  static std::optional<std::vector<double>> Finite(std::vector<double> values, double offset, double si) {
    for (double& value : values) {
      if (!std::isfinite(value)) return std::nullopt;
      value = (value - offset) * si;
    }
    return values;
  }

  std::string Where(std::size_t row) const {
    return table_.line(row) > 0 ? "here" : "at sample " + std::to_string(row + 1);
  }

  double UnitOf(std::size_t column, const RecordedChannel& channel) {
    const std::string text = channel.unit.empty() ? table_.unit(column) : channel.unit;
    const std::optional<Unit> unit = ParseRecordedUnit(text);
    if (unit && unit->dimension == channel.dimension && !channel.integrated_above_Hz) return unit->si;
    if (unit && channel.integrated_above_Hz && IntegralsOf(unit->dimension) > 0) {
      integrals_[channel.names.front()] = IntegralsOf(unit->dimension);
      return unit->si;
    }
    if (channel.integrated_above_Hz) {
      Fault(kNothingToIntegrate, table_.units_line(), {table_.names()[column], text});
      return 1;
    }
    const std::string such = channel.dimension == kLength ? "mm" : SiUnit(channel.dimension);
    const std::string wanted = DimensionName(channel.dimension) + " such as '" + such + "'";
    const std::string& name = table_.names()[column];
    const std::vector<std::string> others =
        channel.dimension == kTime ? Measuring(channel) : std::vector<std::string>();
    const int line = table_.units_line();
    if (text.empty())
      Fault(kUnitMissing, line, {name, channel.what, wanted, table_.WhereUnitsStand(name, such), name, such});
    else if (others.empty()) Fault(kUnitOfOtherDimension, line, {name, channel.what, text, RecordedUnitHint(text), wanted});
    // Times that are in a unit of something else.
    else Fault(kTimeSwapped, line, {name, channel.what, text, wanted, others.front()});
    return 1;
  }

  Dimension DimensionOf(std::size_t column, const RecordedChannel& channel) const {
    const std::optional<Unit> unit = ParseRecordedUnit(channel.unit.empty() ? table_.unit(column) : channel.unit);
    return unit ? unit->dimension : channel.dimension;
  }

  /// That make a length of it.
  static int IntegralsOf(const Dimension& dimension) {
    return dimension == kAcceleration ? 2 : dimension == kVelocity ? 1 : 0;
  }

  /// Times as even as they are asked for, and every channel there.
  void PutOnGrid(std::span<const RecordedChannel> wanted, const std::vector<double>& times,
                 const std::vector<std::size_t>& lengths, const TimePreparation& preparation,
                 TimeRecording& recording) {
    if (!good_) return;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (lengths[i] != times.size())
        return Fault(kSamplesDiffer, 0,
                     {wanted[i].names.front(), std::to_string(lengths[i]), std::to_string(times.size())});
    if (times.size() < 4) return Fault(kTooFewSamples, 0, {std::to_string(times.size())});
    const std::vector<double> steps = StepsOf(times);
    const double usual = UsualStep(steps);
    if (DoStepBack(steps)) return Fault(kTimeDoesNotRise, 0);
    if (!(usual > 0)) {
      const Found fault = FaultOfStanding(times);
      return Fault(*fault.kind, 0, fault.words);
    }
    const double rate_Hz = preparation.rate_Hz.value_or(1 / usual);
    constexpr double kSame = 0.99;
    if (rate_Hz < kSame / usual) return Fault(kResampledBelow, 0, {FormatNumber(rate_Hz), Rate(1 / usual)});
    recording.step_s = 1 / rate_Hz;
    recording.start_s = times.front();
    std::vector<double> grid;
    // The last sample may be there but for the rounding of times.
    const double end_s = times.back() + 1e-6 * recording.step_s;
    for (std::size_t k = 0; recording.time_s(k) <= end_s; ++k) grid.push_back(recording.time_s(k));
    recording.end_s = grid.back();
    const double longest_s = std::max(preparation.bridge_s, kJitter * usual);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      recording.channels[i] =
          OnGrid(wanted[i], times, recording.channels[i], grid, usual, longest_s, held_[i], recording.gaps[i]);
    if (!good_) return;
    if (preparation.rate_Hz) recording.preparations.push_back("resampled to " + FormatNumber(rate_Hz) + " Hz");
    ReportBridged(recording);
  }

  /// A sample that comes later than this many usual steps is a gap.
  static constexpr double kJitter = 1.5;

  std::vector<double> OnGrid(const RecordedChannel& channel, const std::vector<double>& times,
                             const std::vector<double>& values, const std::vector<double>& grid, double usual,
                             double longest_s, const std::vector<BridgedGap>& held, std::vector<BridgedGap>& gaps) {
    std::vector<double> at;
    std::vector<double> known;
    int found = 0;
    // `last`: behind which nothing was measured.
    const auto bridge = [&](BridgedGap gap, std::size_t row, bool last = false) {
      const double gap_s = gap.to_s - gap.from_s;
      if (NotHeld_s(gap, held) > longest_s && found++ < kMostSampleFaults)
        Fault(kGapNotBridged, table_.line(row),
              {channel.names.front(), SecondsText(gap.from_s), SecondsText(gap.to_s), SecondsText(longest_s)});
      if (gap_s <= kJitter * usual) return;
      if (at.empty()) gap.from_s -= usual;
      if (last) gap.to_s += usual;
      gaps.push_back(gap);
    };
    for (std::size_t k = 0; k < times.size(); ++k) {
      // Times that stand or step back now and then are left out.
      if (!std::isfinite(values[k]) || (!at.empty() && times[k] <= at.back())) continue;
      bridge({at.empty() ? times.front() : at.back(), times[k]}, k);
      at.push_back(times[k]);
      known.push_back(values[k]);
    }
    if (!at.empty()) bridge({at.back(), times.back()}, times.size() - 1, true);
    if (at.size() < 3) Fault(kTooFewSamples, 0, {std::to_string(at.size())});
    if (at.size() < 3) return std::vector<double>(grid.size());
    // Before and behind what was measured the end values stand: a cubic would go on by their noise.
    std::vector<double> asked;
    for (const double t : grid) asked.push_back(std::clamp(t, at.front(), at.back()));
    return InterpolatedAt(at, known, asked);
  }

  /// Gaps of the recording, whatever number of channels has each.
  static void ReportBridged(TimeRecording& recording) {
    std::vector<BridgedGap> all;
    for (const std::vector<BridgedGap>& gaps : recording.gaps) all.insert(all.end(), gaps.begin(), gaps.end());
    const std::vector<BridgedGap> merged = MergedGaps(std::move(all));
    if (merged.empty()) return;
    double longest_s = 0;
    for (const BridgedGap& gap : merged) longest_s = std::max(longest_s, gap.to_s - gap.from_s);
    recording.preparations.push_back(Counted(merged.size(), "gap") + " bridged, the longest " + SecondsText(longest_s));
  }

  static std::string Rate(double rate_Hz) { return FormatNumber(std::round(1e4 * rate_Hz) / 1e4); }

  /// Trend, what is slow, and integrals.
  void Prepare(const RecordedChannel& channel, std::vector<double>& values, TimeRecording& recording) {
    const std::string& name = channel.names.front();
    const double rate_Hz = recording.rate_Hz();
    const auto done = [&](const std::string& what) { recording.preparations.push_back(name + ": " + what); };
    if (channel.offset) done("offset taken away");
    if (channel.has_trend) {
      RemoveTrend(values);
      done("trend taken away");
    }
    for (const std::optional<double>& cutoff : {channel.high_pass_Hz, channel.integrated_above_Hz})
      if (cutoff && !(*cutoff < rate_Hz / 2))
        return Fault(kHighPassTooHigh, 0, {FormatNumber(*cutoff), name, Rate(rate_Hz)});
    if (channel.high_pass_Hz) {
      RemoveSlow(values, rate_Hz, *channel.high_pass_Hz);
      done("high-pass of " + FormatNumber(*channel.high_pass_Hz) + " Hz");
    }
    if (!channel.integrated_above_Hz) return;
    const int times = integrals_[name];
    RemoveSlow(values, rate_Hz, *channel.integrated_above_Hz);
    for (int k = 0; k < times; ++k) {
      values = IntegralOf(values, rate_Hz);
      RemoveSlow(values, rate_Hz, *channel.integrated_above_Hz);
    }
    done(std::string("integrated ") + (times == 2 ? "twice" : "once") + ", without what is slower than " +
         FormatNumber(*channel.integrated_above_Hz) + " Hz");
  }

  /// What a channel has beyond the record is not known: all are cut alike.
  void TakeDelaysBack(std::span<const RecordedChannel> wanted, TimeRecording& recording) {
    double latest_s = 0;
    double earliest_s = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double delay_s = wanted[i].delay_s;
      if (delay_s == 0) continue;
      recording.channels[i] = Advanced(recording.channels[i], recording.step_s, delay_s);
      for (BridgedGap& gap : recording.gaps[i]) gap = {gap.from_s - delay_s, gap.to_s - delay_s};
      recording.preparations.push_back(DelayTakenBack(wanted[i].names.front(), delay_s));
      latest_s = std::max(latest_s, delay_s);
      earliest_s = std::min(earliest_s, delay_s);
    }
    // A whole number of samples may be rounded up.
    const auto samples = [&](double delay_s) { return std::ceil(delay_s / recording.step_s - 1e-6); };
    const double first = samples(-earliest_s);
    const double last = samples(latest_s);
    if (first + last + 4 > static_cast<double>(recording.samples())) return Fault(kShorterThanDelays, 0);
    for (std::vector<double>& channel : recording.channels) {
      channel.erase(channel.end() - static_cast<std::ptrdiff_t>(last), channel.end());
      channel.erase(channel.begin(), channel.begin() + static_cast<std::ptrdiff_t>(first));
    }
    recording.start_s += first * recording.step_s;
    recording.end_s -= last * recording.step_s;
  }

  const RecordedTable& table_;
  Diagnostics& diagnostics_;
  bool good_ = true;
  bool times_good_ = true;
  /// Samples may be missing, since gaps are bridged.
  bool may_miss_ = false;
  /// Of each channel, from the last good sample before to the first behind.
  std::vector<std::vector<BridgedGap>> held_;
  /// Of channels that are integrated.
  std::map<std::string, int> integrals_;
};

/// `read` with a reader of the table; a fault that a file shows only then is one of its findings.
template <typename Read>
auto Reading(const RecordedTable& table, Diagnostics& diagnostics, const Read& read) {
  RecordReader reader(table, diagnostics);
  try {
    return read(reader);
  } catch (const FaultyInput& faulty) {
    diagnostics.Add(faulty.diagnostics());
    return decltype(read(reader))();
  }
}

}  // namespace

std::string MillisecondsText(double time_s) { return FormatNumber(std::round(1e6 * time_s) / 1e3) + " ms"; }

std::string DelayTakenBack(const std::string& channel, double delay_s) {
  return channel + ": delay of " + MillisecondsText(delay_s) + " taken back";
}

std::string CutTo(double start_s, double end_s) {
  return "cut to " + FormatNumber(std::round(1e4 * start_s) / 1e4) + " .. " +
         FormatNumber(std::round(1e4 * end_s) / 1e4) + " s";
}

void CheckTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted, Diagnostics& diagnostics,
                        const RecordedChannel& time) {
  Reading(table, diagnostics, [&](RecordReader& reader) { reader.Check(wanted, time); });
}

std::optional<TimeRecording> ReadTimeRecording(const RecordedTable& table, std::span<const RecordedChannel> wanted,
                                               Diagnostics& diagnostics, const RecordedChannel& time,
                                               const TimePreparation& preparation) {
  if (IsSteppedSine(table)) {
    diagnostics.Report(kSteppedSineAsHistory, {table.file(), table.names_line()});
    return std::nullopt;
  }
  return Reading(table, diagnostics, [&](RecordReader& reader) { return reader.Read(wanted, time, preparation); });
}

}  // namespace fourpost
