#include "analysis/charts/bode_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/signals/decibel.h"

namespace fourpost {
namespace {

using Phasors = std::vector<std::complex<double>>;

/// Somewhat more than half a turn, so that what lies about 180 degrees is seen whole.
constexpr double kPhaseEdge_deg = 190;

std::vector<double> Gain_dB(const Phasors& response) {
  std::vector<double> gain;
  for (const std::complex<double>& value : response) gain.push_back(DecibelFromGain(std::abs(value)));
  return gain;
}

/// Without jumps: each phase within half a turn of the one before.
std::vector<double> UnwrappedPhase_deg(const Phasors& response) {
  std::vector<double> phase;
  double last = 0;
  for (const std::complex<double>& value : response) {
    const double wrapped = DegreesFromRadians(std::arg(value));
    phase.push_back(last + std::remainder(wrapped - last, 360));
    if (std::isfinite(phase.back())) last = phase.back();
  }
  return phase;
}

/// Smallest and largest of the finite values.
struct Extent {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void Include(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
  }
};

/// Adds the part of a phase that shows when `turn_deg` is taken off.
void AddTurn(const std::vector<double>& frequency_Hz, const std::vector<double>& phase_deg, double turn_deg,
             SvgSeries& series) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < phase_deg.size(); ++i) {
    const double phase = phase_deg[i] - turn_deg;
    series.x.push_back(frequency_Hz[i]);
    // The line to a neighbour beyond the edge, at most half a turn away, must reach the edge.
    series.y.push_back(std::abs(phase) <= kPhaseEdge_deg + 180 ? phase : none);
  }
  // No line from one turn to the next.
  series.x.push_back(none);
  series.y.push_back(none);
}

}  // namespace

SvgSeries GainSeries(const std::vector<double>& frequency_Hz, const Phasors& response, const SvgStyle& style) {
  return {.style = style, .x = frequency_Hz, .y = Gain_dB(response)};
}

SvgSeries PhaseSeries(const std::vector<double>& frequency_Hz, const Phasors& response, const SvgStyle& style) {
  const std::vector<double> phase = UnwrappedPhase_deg(response);
  Extent extent;
  extent.Include(phase);
  SvgSeries series{.style = style};
  const double first_turn = std::ceil((extent.lower - kPhaseEdge_deg) / 360);
  for (double turn = first_turn; 360 * turn <= extent.upper + kPhaseEdge_deg; ++turn)
    AddTurn(frequency_Hz, phase, 360 * turn, series);
  return series;
}

ChartAxis FrequencyAxis(double lowest_Hz, double highest_Hz) {
  constexpr double kMargin = 1.06;
  return LogAxis(lowest_Hz / kMargin, highest_Hz * kMargin);
}

ChartAxis GainAxis(const std::vector<SvgPanel>& panels) {
  Extent extent;
  for (const SvgPanel& panel : panels)
    for (const SvgSeries& series : panel.series) extent.Include(series.y);
  if (extent.lower > extent.upper) extent = {0, 0};
  // What is less than a ten-thousandth of the largest is silent.
  constexpr double kMost_dB = 80;
  extent.lower = std::max(extent.lower, extent.upper - kMost_dB);
  // Less would show noise as if it were the shape.
  constexpr double kLeast_dB = 6;
  const double lacking = std::max(0.0, kLeast_dB - (extent.upper - extent.lower));
  return LinearAxis(extent.lower - lacking / 2, extent.upper + lacking / 2, 5);
}

ChartAxis PhaseAxis() { return {.lower = -kPhaseEdge_deg, .upper = kPhaseEdge_deg, .ticks = {-180, -90, 0, 90, 180}}; }

std::string GainReference(const std::string& unit) {
  return unit == "m" || unit == "m/s^2" ? "" : "gain re 1 " + unit + "/m";
}

}  // namespace fourpost
