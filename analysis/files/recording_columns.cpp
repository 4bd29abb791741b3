#include "analysis/files/recording_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/time_recording.h"
#include "analysis/signals/spline_through.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Along a straight line from sample to sample; `times` rise.
std::vector<double> Interpolated(const std::vector<double>& times, const std::vector<double>& values,
                                 const std::vector<double>& at) {
  std::vector<double> interpolated;
  interpolated.reserve(at.size());
  std::size_t next = 0;
  for (const double time : at) {
    while (next < times.size() && times[next] < time) ++next;
    if (next == times.size()) interpolated.push_back(values.back());
    else if (next == 0 || times[next] == time) interpolated.push_back(values[next]);
    else
      interpolated.push_back(values[next - 1] + (time - times[next - 1]) / (times[next] - times[next - 1]) *
                                                    (values[next] - values[next - 1]));
  }
  return interpolated;
}

std::vector<double> Splined(double start, double step, const std::vector<double>& values,
                            const std::vector<double>& at) {
  const UniformSpline spline = SplineThrough(values, start, step);
  std::vector<double> splined;
  splined.reserve(at.size());
  for (const double time : at) splined.push_back(spline.At(time).value);
  return splined;
}

bool IsFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// A file that is faulty behind its header ends what reads it.
template <typename Read>
auto Guarded(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const RecordingFault& fault) {
    Refuse(*fault.found().kind, {file, fault.line()}, fault.found().words);
  }
}

std::string RateText(double step_s) { return FormatNumber(std::round(1e4 / step_s) / 1e4) + " Hz"; }

}  // namespace

RecordingColumns::RecordingColumns(std::shared_ptr<const RecordingFile> file, std::string name,
                                   Diagnostics& diagnostics)
    : file_(std::move(file)), name_(std::move(name)), held_(kNone) {
  const std::vector<RecordingChannel>& channels = header().channels;
  has_times_ = std::any_of(channels.begin(), channels.end(), [](const RecordingChannel& c) { return c.HasTimes(); });
  if (has_times_) {
    names_.push_back(kTimeColumn.names.front());
    units_.emplace_back("s");
    channels_.push_back(0);
  }
  std::string left_out;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (has_times_ && !channels[i].HasTimes()) {
      left_out += (left_out.empty() ? "" : ", ") + channels[i].name;
      continue;
    }
    const bool is_taken = has_times_ && channels[i].name == names_.front();
    names_.push_back(is_taken ? channels[i].name + " (channel)" : channels[i].name);
    units_.push_back(channels[i].unit);
    channels_.push_back(i);
  }
  if (!left_out.empty()) diagnostics.Report(kChannelsWithoutTimes, {name_}, {left_out});
  if (has_times_) Guarded(name_, [&] { ReadClocks(diagnostics); });
}

std::size_t RecordingColumns::rows(std::size_t column) const {
  return has_times_ ? times_s_.size() : header().channels[channels_[column]].samples;
}

double RecordingColumns::rate_Hz(std::size_t column) const {
  if (!has_times_ || column == 0) return 0;
  const double step_s = clocks_[clock_of_[column]].step_s;
  return step_s > 0 ? 1 / step_s : 0;
}

std::vector<double> RecordingColumns::Recorded(std::size_t column) const {
  return Guarded(name_, [&] { return IsTimes(column) ? times_s_ : file_->Values(channels_[column]); });
}

const std::vector<double>& RecordingColumns::Column(std::size_t column) const {
  if (IsTimes(column)) return times_s_;
  if (held_ == column) return values_;
  values_ = Guarded(name_, [&] { return has_times_ ? OnTimes(column) : file_->Values(channels_[column]); });
  held_ = column;
  return values_;
}

std::size_t RecordingColumns::ClockOf(std::size_t channel) {
  const RecordingChannel& head = header().channels[channel];
  for (std::size_t i = 0; i < clocks_.size(); ++i) {
    const RecordingChannel& other = header().channels[clocks_[i].channel];
    const bool is_same = head.clock ? head.clock == other.clock
                                    : !other.clock && head.step_s == other.step_s && head.start_s == other.start_s &&
                                          head.samples == other.samples;
    if (is_same) return i;
  }
  Clock clock = {.channel = channel, .start_s = head.start_s, .step_s = head.step_s, .samples = head.samples};
  if (head.clock) {
    clock.times_s = file_->Times(channel);
    clock.samples = clock.times_s.size();
    // Groups of one rate may each have written the times.
    for (std::size_t i = 0; i < clocks_.size(); ++i)
      if (!clocks_[i].times_s.empty() && clocks_[i].times_s == clock.times_s) return i;
    if (clock.samples > 0) clock.start_s = clock.times_s.front();
    if (clock.samples > 0) clock.end_s = clock.times_s.back();
    clock.step_s = clock.samples > 1 ? (clock.end_s - clock.start_s) / static_cast<double>(clock.samples - 1) : 0;
  } else {
    clock.end_s = clock.start_s + clock.step_s * static_cast<double>(std::max<std::size_t>(clock.samples, 1) - 1);
  }
  clocks_.push_back(std::move(clock));
  return clocks_.size() - 1;
}

void RecordingColumns::ReadClocks(Diagnostics& diagnostics) {
  clock_of_.push_back(0);
  for (std::size_t column = 1; column < channels_.size(); ++column) clock_of_.push_back(ClockOf(channels_[column]));
  ChooseTimes(diagnostics);
  has_several_rates_ = clocks_.size() > 1;
  if (has_several_rates_) ReportRates(diagnostics);
}

void RecordingColumns::ChooseTimes(Diagnostics& diagnostics) {
  const auto is_faster = [](const Clock& a, const Clock& b) {
    return a.step_s > 0 && (!(b.step_s > 0) || a.step_s < b.step_s);
  };
  const auto fastest = std::min_element(clocks_.begin(), clocks_.end(), is_faster);
  clock_of_[0] = static_cast<std::size_t>(fastest - clocks_.begin());
  double start_s = fastest->start_s;
  double end_s = fastest->end_s;
  for (const Clock& clock : clocks_) {
    start_s = std::max(start_s, clock.start_s);
    end_s = std::min(end_s, clock.end_s);
  }
  // Within the rounding of starts and steps.
  const double rounding = clocks_.size() > 1 ? 1e-6 * fastest->step_s : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < fastest->samples; ++k) {
    const double time =
        fastest->times_s.empty() ? fastest->start_s + fastest->step_s * static_cast<double>(k) : fastest->times_s[k];
    if (clocks_.size() == 1 || (time >= start_s - rounding && time <= end_s + rounding)) times_s_.push_back(time);
  }
  if (times_s_.empty()) {
    const auto late = std::max_element(clocks_.begin(), clocks_.end(),
                                       [](const Clock& a, const Clock& b) { return a.start_s < b.start_s; });
    diagnostics.Report(
        kNoCommonTime, {name_},
        {header().channels[late->channel].name, FormatNumber(late->start_s) + " s", FormatNumber(end_s) + " s"});
  }
}

void RecordingColumns::ReportRates(Diagnostics& diagnostics) const {
  std::string slower;
  double slowest_s = 0;
  for (std::size_t column = 1; column < channels_.size(); ++column) {
    if (clock_of_[column] == clock_of_[0]) continue;
    slower += (slower.empty() ? "" : ", ") + names_[column];
    slowest_s = std::max(slowest_s, clocks_[clock_of_[column]].step_s);
  }
  if (slowest_s > 0)
    diagnostics.Report(
        kChannelsInterpolated, {name_},
        {slower, RateText(clocks_[clock_of_[0]].step_s), FormatNumber(std::round(2e3 / slowest_s) / 1e4) + " Hz"});
}

std::vector<double> RecordingColumns::OnTimes(std::size_t column) const {
  std::vector<double> values = file_->Values(channels_[column]);
  const Clock& clock = clocks_[clock_of_[column]];
  const Clock& base = clocks_[clock_of_[0]];
  const auto cut = [&](std::size_t first) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(first, values.size())));
    values.resize(times_s_.size(), std::numeric_limits<double>::quiet_NaN());
    return values;
  };
  if (values.empty()) return cut(0);
  if (&clock == &base && times_s_.size() == base.samples) return cut(0);
  if (clock.times_s.empty()) {
    // Samples of one rate stay as they are.
    const double first = (times_s_.front() - clock.start_s) / clock.step_s;
    const bool is_same = base.times_s.empty() &&
                         std::abs(clock.step_s / base.step_s - 1) * static_cast<double>(base.samples) < 1e-3 &&
                         std::abs(first - std::round(first)) < 1e-3;
    if (is_same) return cut(static_cast<std::size_t>(std::max(std::round(first), 0.0)));
    if (IsFinite(values) && values.size() > 1) return Splined(clock.start_s, clock.step_s, values, times_s_);
    return Interpolated(file_->Times(channels_[column]), values, times_s_);
  }
  if (&clock == &base) {
    const auto first = std::find(clock.times_s.begin(), clock.times_s.end(), times_s_.front());
    return cut(static_cast<std::size_t>(first - clock.times_s.begin()));
  }
  return Interpolated(clock.times_s, values, times_s_);
}

}  // namespace fourpost
