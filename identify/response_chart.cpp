#include "identify/response_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/decibel.h"
#include "analysis/number.h"
#include "analysis/svg_chart.h"

namespace fourpost {
namespace {

using Phasors = std::vector<std::complex<double>>;

/// Somewhat more than half a turn, so that what lies about 180 degrees is seen whole.
constexpr double kPhaseEdge_deg = 190;

/// Two colours of Okabe and Ito that the colour-blind tell apart, and that differ in lightness.
SvgStyle Measured() { return {.label = "measured", .color = "#0072B2", .mark = SvgMark::kDots}; }
SvgStyle Modelled() { return {.label = "modelled", .color = "#D55E00", .mark = SvgMark::kLine}; }

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

SvgSeries GainSeries(const std::vector<double>& frequency_Hz, const Phasors& response, const SvgStyle& style) {
  return {.style = style, .x = frequency_Hz, .y = Gain_dB(response)};
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

/// The phase as a curve on a cylinder, cut open at the edges: it is drawn once for each turn that shows, so that it
/// leaves at one edge and comes back at the other, and measurement and model are always next to each other.
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

/// The frequencies of all runs, with a margin for the dots at the ends.
ChartAxis FrequencyAxis(const std::vector<MeasuredRun>& runs) {
  constexpr double kMargin = 1.06;
  Extent extent;
  for (const MeasuredRun& run : runs) extent.Include(run.excitation.frequency_Hz);
  return LogAxis(extent.lower / kMargin, extent.upper * kMargin);
}

/// One for all runs, so that they compare.
ChartAxis GainAxis(const std::vector<SvgPanel>& panels) {
  Extent extent;
  for (const SvgPanel& panel : panels)
    for (const SvgSeries& series : panel.series) extent.Include(series.y);
  if (extent.lower > extent.upper) extent = {0, 0};
  // Less would show noise as if it were the shape.
  constexpr double kLeast_dB = 6;
  const double lacking = std::max(0.0, kLeast_dB - (extent.upper - extent.lower));
  return LinearAxis(extent.lower - lacking / 2, extent.upper + lacking / 2, 5);
}

ChartAxis PhaseAxis() { return {.lower = -kPhaseEdge_deg, .upper = kPhaseEdge_deg, .ticks = {-180, -90, 0, 90, 180}}; }

/// A channel of one run, measured and modelled; null when the run has it not.
struct ChannelPair {
  const MeasuredChannel* measured = nullptr;
  const ChannelResponse* modelled = nullptr;
};

ChannelPair FindChannel(const std::string& name, const MeasuredRun& run, const FrequencyResponse& modelled) {
  const auto found = std::find_if(run.channels.begin(), run.channels.end(),
                                  [&](const MeasuredChannel& channel) { return channel.name == name; });
  if (found == run.channels.end()) return {};
  return {&*found, &modelled.channels[found->sensor]};
}

/// Responses are per metre of the post; those of displacements and accelerations are plain ratios.
std::string GainReference(const std::string& unit) {
  return unit == "m" || unit == "m/s^2" ? "" : "; gain re 1 " + unit + "/m";
}

std::string OneDecimal(double value) { return FormatNumber(std::round(value * 10) / 10); }

class ResponseChart {
 public:
  ResponseChart(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, double lower_Hz,
                double upper_Hz)
      : runs_(runs),
        modelled_(modelled),
        empty_panel_{.x = FrequencyAxis(runs), .clear_lower = lower_Hz, .clear_upper = upper_Hz} {}

  SvgRow Row(const ChannelMisfit& channel) const {
    std::vector<SvgPanel> gains;
    std::vector<SvgPanel> phases;
    std::string unit = "m";
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const ChannelPair pair = FindChannel(channel.name, runs_[r], modelled_[r]);
      gains.push_back(Panel(pair, runs_[r], GainSeries));
      phases.push_back(Panel(pair, runs_[r], PhaseSeries));
      if (pair.measured) unit = pair.measured->unit;
    }
    return {.title = channel.name,
            .note = "rms " + OneDecimal(channel.rms_dB) + " dB, " + OneDecimal(channel.rms_deg) + " deg" +
                    GainReference(unit),
            .panels = Interleaved(gains, phases)};
  }

 private:
  template <typename MakeSeries>
  SvgPanel Panel(const ChannelPair& pair, const MeasuredRun& run, MakeSeries make_series) const {
    SvgPanel panel = empty_panel_;
    if (!pair.measured) return panel;
    panel.series.push_back(make_series(run.excitation.frequency_Hz, pair.measured->response, Measured()));
    panel.series.push_back(make_series(run.excitation.frequency_Hz, pair.modelled->response, Modelled()));
    return panel;
  }

  static std::vector<SvgPanel> Interleaved(const std::vector<SvgPanel>& gains, const std::vector<SvgPanel>& phases) {
    std::vector<SvgPanel> panels;
    const ChartAxis gain_axis = GainAxis(gains);
    for (std::size_t r = 0; r < gains.size(); ++r) {
      panels.push_back(gains[r]);
      panels.back().y = gain_axis;
      panels.push_back(phases[r]);
      panels.back().y = PhaseAxis();
    }
    return panels;
  }

  const std::vector<MeasuredRun>& runs_;
  const std::vector<FrequencyResponse>& modelled_;
  SvgPanel empty_panel_;
};

}  // namespace

std::string ResponseSvg(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                        const std::vector<ChannelMisfit>& channels, double lower_Hz, double upper_Hz) {
  if (runs.empty()) throw std::invalid_argument("a chart of responses needs a run");
  SvgSheet sheet{.title = "Response to the posts, measured and modelled",
                 .note = "fitted from " + FormatNumber(lower_Hz) + " to " + FormatNumber(upper_Hz) +
                         " Hz (white); rms of the difference there",
                 .legend = {Measured(), Modelled()},
                 .x_label = "frequency [Hz]"};
  for (const MeasuredRun& run : runs) {
    sheet.columns.push_back(run.name + ": gain [dB]");
    sheet.columns.push_back(run.name + ": phase [deg]");
  }
  const ResponseChart chart(runs, modelled, lower_Hz, upper_Hz);
  for (const ChannelMisfit& channel : channels) sheet.rows.push_back(chart.Row(channel));
  return SvgText(sheet);
}

}  // namespace fourpost
