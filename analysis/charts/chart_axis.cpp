#include "analysis/charts/chart_axis.h"

#include <cmath>
#include <stdexcept>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// digits times ten to the exponent, rounded once: 3 and -1 are the double 0.3.
double Decimal(double digits, int exponent) {
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? digits / power : digits * power;
}

/// Numbers of the ticks of a step between which a range lies.
struct TickRange {
  double first = 0;
  double last = 0;
};

TickRange Around(double lower, double upper, double step) {
  // A limit on a tick must not become the next one by rounding.
  constexpr double kSlack = 1e-9;
  return {std::floor(lower / step + kSlack), std::ceil(upper / step - kSlack)};
}

ChartAxis FromTickToTick(TickRange range, double digit, int exponent) {
  ChartAxis axis;
  for (int i = 0; i <= static_cast<int>(range.last - range.first); ++i)
    axis.ticks.push_back(Decimal((range.first + i) * digit, exponent));
  axis.lower = axis.ticks.front();
  axis.upper = axis.ticks.back();
  return axis;
}

int DecadeOf(double value) { return static_cast<int>(std::floor(std::log10(value))); }

struct DigitTick {
  double value = 0;
  bool main = false;
};

/// 1..9 times a power of ten within the limits; 1, 2 and 5 are the main ones.
std::vector<DigitTick> DigitsWithin(double lower, double upper) {
  std::vector<DigitTick> ticks;
  for (int decade = DecadeOf(lower); decade <= DecadeOf(upper); ++decade)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = Decimal(digit, decade);
      if (value >= lower && value <= upper) ticks.push_back({value, digit == 1 || digit == 2 || digit == 5});
    }
  return ticks;
}

std::vector<double> LogTicks(double lower, double upper) {
  // Ratio of 30 to 20 and of 0.5 to 0.3, but not of 60 to 50, whose labels would touch.
  constexpr double kRoom = 1.4;
  const std::vector<DigitTick> digits = DigitsWithin(lower, upper);
  std::vector<double> ticks;
  for (const DigitTick& tick : digits)
    if (tick.main) ticks.push_back(tick.value);
  if (ticks.empty()) return ticks;
  if (ticks.front() >= kRoom * digits.front().value) ticks.insert(ticks.begin(), digits.front().value);
  if (digits.back().value >= kRoom * ticks.back()) ticks.push_back(digits.back().value);
  return ticks;
}

}  // namespace

double ChartAxis::Fraction(double value) const {
  if (logarithmic) return std::log(value / lower) / std::log(upper / lower);
  return (value - lower) / (upper - lower);
}

void ChartAxis::Validate() const {
  const std::string limits = FormatNumber(lower) + " to " + FormatNumber(upper);
  if (!(lower < upper) || !std::isfinite(upper - lower))
    throw std::invalid_argument("the limits of an axis must be finite and increase, not " + limits);
  if (logarithmic && lower <= 0)
    throw std::invalid_argument("the limits of a logarithmic axis must be positive, not " + limits);
}

ChartAxis LinearAxis(double lower, double upper, int intervals) {
  ChartAxis{.lower = lower, .upper = upper}.Validate();
  if (intervals < 2) throw std::invalid_argument("an axis needs two intervals, not " + std::to_string(intervals));
  for (int exponent = DecadeOf((upper - lower) / intervals);; ++exponent)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const TickRange range = Around(lower, upper, Decimal(digit, exponent));
      if (range.last - range.first <= intervals) return FromTickToTick(range, digit, exponent);
    }
}

ChartAxis LogAxis(double lower, double upper) {
  ChartAxis axis{.lower = lower, .upper = upper, .logarithmic = true};
  axis.Validate();
  axis.ticks = LogTicks(lower, upper);
  if (axis.ticks.size() >= 2) return axis;
  axis.ticks.clear();
  for (const double tick : LinearAxis(lower, upper, 6).ticks)
    if (tick >= lower && tick <= upper) axis.ticks.push_back(tick);
  return axis;
}

}  // namespace fourpost
