#include "identify/experiments/four_post/response_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/charts/bode_panel.h"
#include "analysis/charts/svg_chart.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// Two colours of Okabe and Ito that the colour-blind tell apart, and that differ in lightness.
SvgStyle Measured() { return {.label = "measured", .color = "#0072B2", .mark = SvgMark::kDots}; }
SvgStyle Modelled() { return {.label = "modelled", .color = "#D55E00", .mark = SvgMark::kLine}; }

ChartAxis AxisOver(const std::vector<MeasuredRun>& runs) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0;
  for (const MeasuredRun& run : runs)
    for (const double frequency : run.excitation.frequency_Hz) {
      lowest = std::min(lowest, frequency);
      highest = std::max(highest, frequency);
    }
  return FrequencyAxis(lowest, highest);
}

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

std::string OneDecimal(double value) { return FormatNumber(std::round(value * 10) / 10); }

class ResponseChart {
 public:
  ResponseChart(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, double lower_Hz,
                double upper_Hz)
      : runs_(runs),
        modelled_(modelled),
        empty_panel_{.x = AxisOver(runs), .clear_lower = lower_Hz, .clear_upper = upper_Hz} {}

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
    const std::string reference = GainReference(unit);
    return {.title = channel.name,
            .note = "rms " + OneDecimal(channel.rms_dB) + " dB, " + OneDecimal(channel.rms_deg) + " deg" +
                    (reference.empty() ? "" : "; ") + reference,
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
  const bool is_fitted =
      std::any_of(runs.begin(), runs.end(), [](const MeasuredRun& run) { return !run.is_validation; });
  SvgSheet sheet{.title = "Response to the posts, measured and modelled",
                 .note = (is_fitted ? "fitted from " : "not fitted; band from ") + FormatNumber(lower_Hz) + " to " +
                         FormatNumber(upper_Hz) + " Hz (white); rms of the difference there",
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
