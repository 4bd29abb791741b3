#include "analysis/files/sample_times.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/findings.h"
#include "analysis/signals/median.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// A column that looks like times.
std::optional<std::string> EvenlyRising(const RecordedTable& table) {
  for (std::size_t column = 0; column < table.names().size(); ++column) {
    std::vector<double> steps;
    for (std::size_t row = 1; row < table.rows(column); ++row)
      steps.push_back(table.Number(row, column).value_or(NAN) - table.Number(row - 1, column).value_or(NAN));
    if (steps.size() < 3) continue;
    const double usual = (table.Number(steps.size(), column).value_or(NAN) - table.Number(0, column).value_or(NAN)) /
                         static_cast<double>(steps.size());
    const auto is_even = [&](double step) { return std::abs(step - usual) < 0.5 * usual; };
    if (std::all_of(steps.begin(), steps.end(), is_even)) return table.names()[column];
  }
  return std::nullopt;
}

class TimeCheck {
 public:
  TimeCheck(const RecordedTable& table, const std::vector<double>& times, Diagnostics& diagnostics)
      : table_(table), times_(times), diagnostics_(diagnostics) {}

  std::optional<double> Step() {
    if (times_.size() < 4) return Refused(kTooFewSamples, 0, {std::to_string(times_.size())});
    const std::vector<double> steps = StepsOf(times_);
    const double usual = UsualStep(steps);
    if (DoStepBack(steps))
      if (const std::optional<std::string> even = EvenlyRising(table_)) return Refused(kTimeStepsBack, 0, {*even});
    if (!(usual > 0)) {
      const Found fault = FaultOfStanding(times_);
      return Refused(*fault.kind, 0, fault.words);
    }
    if (!AreEven(steps, usual)) return std::nullopt;
    const double step = (times_.back() - times_.front()) / static_cast<double>(steps.size());
    // Rounded times are off by the last digit, which steps have two sizes by.
    const double slack = usual == Median(steps) ? 0.5 * step : Median(steps);
    return DoDrift(step, slack) ? std::nullopt : std::optional(step);
  }

 private:
  std::nullopt_t Refused(const Finding& kind, int line, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(kind, {table_.file(), line}, words);
    return std::nullopt;
  }

  bool AreEven(const std::vector<double>& steps, double usual) {
    int found = 0;
    for (std::size_t k = 0; k < steps.size() && found < kMostSampleFaults; ++k) {
      // Half a step is more than any rounding of times, and less than a sample that is lost.
      if (std::abs(steps[k] - usual) < 0.5 * usual) continue;
      ++found;
      Refused(kTimeStepUneven, table_.line(k + 1),
              {FormatNumber(times_[k]) + " s", FormatNumber(times_[k + 1]) + " s", SecondsText(usual)});
    }
    return found == 0;
  }

  /// Steps that each look well may still add up to another rate.
  bool DoDrift(double step, double slack) {
    std::size_t worst = 0;
    const auto off = [&](std::size_t k) { return times_[k] - times_.front() - step * static_cast<double>(k); };
    for (std::size_t k = 0; k < times_.size(); ++k)
      if (std::abs(off(k)) > std::abs(off(worst))) worst = k;
    if (std::abs(off(worst)) < slack) return false;
    Refused(kTimeDrifts, table_.line(worst), {SecondsText(off(worst)), SecondsText(step)});
    return true;
  }

  const RecordedTable& table_;
  const std::vector<double>& times_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::string SecondsText(double time_s) { return FormatNumber(std::round(1e9 * time_s), -9) + " s"; }

double UsualStep(const std::vector<double>& steps) {
  constexpr double kOff = 0.01;
  constexpr double kLonger = 1.25;
  constexpr double kTwice = 2.01;
  // Where fewer steps are longer, samples were lost; of few steps one is a large share.
  constexpr double kShareOfRounding = 0.2;
  constexpr std::size_t kFewest = 20;
  const double middle = Median(steps);
  const auto is_longer = [&](double step) { return step > kLonger * middle && step < kTwice * middle; };
  const auto longer = static_cast<double>(std::count_if(steps.begin(), steps.end(), is_longer));
  if (steps.size() < kFewest || longer < kShareOfRounding * static_cast<double>(steps.size())) return middle;
  double sum = 0;
  double count = 0;
  for (const double step : steps) {
    if (!(step > 0 && step < kTwice * middle)) continue;
    sum += step;
    count += 1;
  }
  return std::abs(sum / count - middle) > kOff * middle ? sum / count : middle;
}

std::vector<double> StepsOf(const std::vector<double>& times) {
  std::vector<double> steps(times.empty() ? 0 : times.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = times[k + 1] - times[k];
  return steps;
}

Found FaultOfStanding(const std::vector<double>& times) {
  const double duration_s = times.back() - times.front();
  if (!std::is_sorted(times.begin(), times.end()) || !(duration_s > 0)) return {&kTimeDoesNotRise, {}};
  return {&kTimeTooCoarse,
          {std::to_string(times.size()), SecondsText(duration_s),
           FormatNumber(std::round(static_cast<double>(times.size()) / duration_s))}};
}

bool DoStepBack(const std::vector<double>& steps) {
  constexpr double kOften = 0.3;
  const auto back = std::count_if(steps.begin(), steps.end(), [](double step) { return step < 0; });
  return static_cast<double>(back) > kOften * static_cast<double>(steps.size());
}

std::optional<double> EvenStepOf(const RecordedTable& table, const std::vector<double>& times,
                                 Diagnostics& diagnostics) {
  return TimeCheck(table, times, diagnostics).Step();
}

}  // namespace fourpost
