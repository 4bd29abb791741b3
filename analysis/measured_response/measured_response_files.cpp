#include "analysis/measured_response/measured_response_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/charts/bode_panel.h"
#include "analysis/charts/svg_chart.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/files/universal/universal_writer.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/counted.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Digits of a file: far finer than any deviation.
double Written(double value) { return AtDigits(value, 10); }

SvgStyle Measured() { return {.label = "measured", .color = "#0072B2", .mark = SvgMark::kLine}; }
SvgStyle Bounds() {
  return {.label = "two standard deviations", .color = "#E69F00", .mark = SvgMark::kLine, .width = 1};
}

/// Both edges of a band as one broken line.
SvgSeries BandSeries(const std::vector<double>& frequency_Hz, const std::vector<double>& lower,
                     const std::vector<double>& upper) {
  SvgSeries series{.style = Bounds(), .x = {}, .y = {}};
  for (const std::vector<double>* edge : {&lower, &upper}) {
    series.x.insert(series.x.end(), frequency_Hz.begin(), frequency_Hz.end());
    series.y.insert(series.y.end(), edge->begin(), edge->end());
    series.x.push_back(std::numeric_limits<double>::quiet_NaN());
    series.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

SvgPanel GainPanel(const std::vector<double>& frequency_Hz, const ChannelResponse& channel) {
  SvgPanel panel{.x = FrequencyAxis(frequency_Hz.front(), frequency_Hz.back())};
  std::vector<double> lower;
  std::vector<double> upper;
  for (std::size_t i = 0; i < frequency_Hz.size(); ++i) {
    const double gain = std::abs(channel.response[i]);
    lower.push_back(DecibelFromGain(std::max(0.0, gain - 2 * channel.gain_sd[i])));
    upper.push_back(DecibelFromGain(gain + 2 * channel.gain_sd[i]));
  }
  panel.series = {BandSeries(frequency_Hz, lower, upper), GainSeries(frequency_Hz, channel.response, Measured())};
  std::vector<SvgPanel> gains = {panel};
  // Where noise is all there is, its band would set the axis.
  gains.front().series.erase(gains.front().series.begin());
  panel.y = GainAxis(gains);
  return panel;
}

SvgPanel PhasePanel(const std::vector<double>& frequency_Hz, const ChannelResponse& channel) {
  SvgPanel panel{.x = FrequencyAxis(frequency_Hz.front(), frequency_Hz.back())};
  for (const double side : {-2.0, 2.0}) {
    std::vector<std::complex<double>> edge;
    for (std::size_t i = 0; i < frequency_Hz.size(); ++i)
      edge.push_back(channel.response[i] * std::polar(1.0, side * std::min(1.5, channel.phase_sd_rad[i])));
    panel.series.push_back(PhaseSeries(frequency_Hz, edge, Bounds()));
  }
  panel.series.push_back(PhaseSeries(frequency_Hz, channel.response, Measured()));
  panel.y = PhaseAxis();
  return panel;
}

SvgPanel CoherencePanel(const std::vector<double>& frequency_Hz, const ChannelQuality& quality) {
  SvgPanel panel{.x = FrequencyAxis(frequency_Hz.front(), frequency_Hz.back())};
  panel.series.push_back({.style = Measured(), .x = frequency_Hz, .y = quality.coherence_at});
  panel.y = LinearAxis(0, 1, 4);
  return panel;
}

std::string Shares(const MeasuredResponses& measured, const MeasuredResponse& response) {
  std::string text;
  for (std::size_t p = 0; p < measured.posts.size(); ++p)
    text += (p > 0 ? ", " : "") + measured.posts[p] + ": " + FormatNumber(response.shares.share[p]);
  return "{" + text + "}";
}

std::string Percent(double share, int digits = 2) {
  return std::isfinite(share) ? Rounded(100 * share, digits) : "none";
}

std::string FoundText(const MeasuredResponses& measured) {
  std::string text = KindInWords(measured.kind) + ", " + Rounded(measured.duration_s, 4) + " s at " +
                     Rounded(measured.rate_Hz, 4) + " Hz; ";
  switch (measured.kind) {
    case ExcitationKind::kStepped:
      text += Counted(measured.dwells, "dwell") + ", " + Rounded(measured.median_cycles, 3) + " settled cycles" +
              (measured.dwells == 1 ? "" : " each (median)") + "; mean offsets " +
              (measured.has_means ? "relative to rest" : "not known");
      for (const std::string& without : measured.without_rest) text += '\n' + without;
      break;
    case ExcitationKind::kSweep:
    case ExcitationKind::kRandom:
      text += Rounded(measured.least_averages, 3) + " to " + Rounded(measured.most_averages, 3) +
              " independent averages at each frequency";
      break;
    case ExcitationKind::kMultisine:
      text += std::to_string(measured.periods) + " settled periods of " + Rounded(measured.period_s, 4) + " s";
      break;
  }
  return text + '\n';
}

TextTable TableOf(const MeasuredResponses& measured, const MeasuredResponse& response) {
  const bool is_local = measured.kind == ExcitationKind::kSweep || measured.kind == ExcitationKind::kRandom;
  const bool is_stepped = measured.kind == ExcitationKind::kStepped;
  std::vector<std::string> head = {"channel", "unit", "median sd, %"};
  if (is_local) head.insert(head.end(), {"lowest coherence", "at Hz"});
  if (is_stepped) head.insert(head.end(), {"largest distortion, %", "at Hz"});
  if (measured.kind == ExcitationKind::kMultisine) head.insert(head.end(), {"noise, %", "distortion, %"});
  TextTable table(head);
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const ChannelQuality& quality = response.channels[c];
    std::vector<std::string> row = {quality.name, response.response.channels[c].unit, Percent(quality.deviation)};
    if (is_local) row.insert(row.end(), {Rounded(quality.coherence, 4), Rounded(quality.coherence_Hz, 3)});
    if (is_stepped)
      row.insert(row.end(),
                 {Percent(quality.distortion), quality.distortion_Hz > 0 ? Rounded(quality.distortion_Hz, 3) : "none"});
    if (measured.kind == ExcitationKind::kMultisine)
      row.insert(row.end(), {Percent(quality.noise), Percent(quality.distortion)});
    table.Add(row);
  }
  return table;
}

/// Of each channel the mean offset that is largest beside its standard deviation; empty without means.
std::string MeansText(const MeasuredResponse& response) {
  TextTable table({"channel", "unit", "mean offset", "sd", "at Hz"});
  bool has_rows = false;
  for (const ChannelResponse& channel : response.response.channels) {
    std::size_t most = 0;
    const auto size = [&](std::size_t i) {
      return std::abs(channel.mean[i]) / std::max(1e-300, channel.mean_sd.empty() ? 1 : channel.mean_sd[i]);
    };
    for (std::size_t i = 1; i < channel.mean.size(); ++i)
      if (size(i) > size(most)) most = i;
    if (channel.mean.empty()) continue;
    has_rows = true;
    const bool is_length = channel.unit == "m";
    const double scale = is_length ? 1e3 : 1;
    table.Add({channel.name, is_length ? "mm" : channel.unit, Rounded(scale * channel.mean[most], 3),
               channel.mean_sd.empty() ? "none" : Rounded(scale * channel.mean_sd[most], 2),
               Rounded(response.response.frequency_Hz[most], 3)});
  }
  return has_rows ? "mean offsets relative to rest, each where it is surest; of all frequencies in columns 'mean' and "
                    "'mean_sd' of " +
                        response.name + ".csv, which -o writes\n" + table.Format()
                  : "";
}

std::string ResponseText(const MeasuredResponses& measured, const MeasuredResponse& response) {
  const FrequencyResponse& values = response.response;
  const auto [least, most] = std::minmax_element(values.amplitude_m.begin(), values.amplitude_m.end());
  const bool is_one = values.frequency_Hz.size() == 1;
  std::string text = response.name + ": posts " + Shares(measured, response) + ", the reference is " +
                     measured.posts[response.shares.reference] + "; " +
                     (response.shares.rest < 1e-4 ? "less than 0.01" : Percent(response.shares.rest)) +
                     " % of their motion is off this pattern\n" +
                     (is_one ? "1 frequency, " : std::to_string(values.frequency_Hz.size()) + " frequencies from ") +
                     Rounded(values.frequency_Hz.front(), 4) +
                     (is_one ? "" : " to " + Rounded(values.frequency_Hz.back(), 4)) + " Hz, post amplitude " +
                     Rounded(1e3 * *least, 3) + (*most > 1.001 * *least ? " to " + Rounded(1e3 * *most, 3) : "") +
                     " mm";
  if (!response.repeats.empty()) {
    const auto [fewest, all] = std::minmax_element(response.repeats.begin(), response.repeats.end());
    if (*all > 1)
      text += ", " + std::to_string(*fewest) + (*fewest == *all ? "" : " to " + std::to_string(*all)) + " dwells each";
  }
  return text + '\n' + TableOf(measured, response).Format() + MeansText(response);
}

Json Numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(NumberOrNull(value));
  return list;
}

Json ChannelsJson(const MeasuredResponse& response) {
  Json list = Json::array();
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const ChannelQuality& quality = response.channels[c];
    const ChannelResponse& channel = response.response.channels[c];
    std::vector<double> gain;
    std::vector<double> phase_deg;
    std::vector<double> phase_sd_deg;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      gain.push_back(std::abs(channel.response[i]));
      phase_deg.push_back(DegreesFromRadians(std::arg(channel.response[i])));
      phase_sd_deg.push_back(DegreesFromRadians(channel.phase_sd_rad[i]));
    }
    std::vector<double> gain_h2;
    std::vector<double> gain_hv;
    for (std::size_t i = 0; i < quality.coherence_at.size(); ++i) {
      gain_h2.push_back(gain[i] / quality.coherence_at[i]);
      gain_hv.push_back(gain[i] / std::sqrt(quality.coherence_at[i]));
    }
    list.push_back({{"name", channel.name},
                    {"unit", channel.unit},
                    {"gain", Numbers(gain)},
                    {"phase_deg", Numbers(phase_deg)},
                    {"gain_sd", Numbers(channel.gain_sd)},
                    {"phase_sd_deg", Numbers(phase_sd_deg)},
                    {"mean", Numbers(channel.mean)},
                    {"mean_sd", Numbers(channel.mean_sd)},
                    {"second_harmonic", Numbers(channel.second_harmonic)},
                    {"coherence", Numbers(quality.coherence_at)},
                    {"gain_h2", Numbers(gain_h2)},
                    {"gain_hv", Numbers(gain_hv)},
                    {"distortion", NumberOrNull(quality.distortion)},
                    {"noise", NumberOrNull(quality.noise)},
                    {"median_sd_share", NumberOrNull(quality.deviation)}});
  }
  return list;
}

}  // namespace

std::string RecordingCsv(const FrequencyResponse& response) {
  CsvWriter csv({"frequency_Hz", "post_amplitude_m", "channel", "unit", "gain", "phase_deg", "gain_sd", "phase_sd_deg",
                 "mean", "mean_sd", "second_harmonic"});
  const auto at = [](const std::vector<double>& values, std::size_t i) {
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : Written(values[i]);
  };
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i)
    for (const ChannelResponse& channel : response.channels) {
      csv.Add(Written(response.frequency_Hz[i])).Add(Written(response.amplitude_m[i]));
      csv.Add(channel.name).Add(channel.unit);
      csv.Add(Written(std::abs(channel.response[i])));
      csv.Add(Written(DegreesFromRadians(std::arg(channel.response[i]))));
      csv.Add(Written(channel.gain_sd[i])).Add(Written(DegreesFromRadians(channel.phase_sd_rad[i])));
      csv.Add(at(channel.mean, i)).Add(at(channel.mean_sd, i)).Add(at(channel.second_harmonic, i));
    }
  return csv.text();
}

std::string RecordingUniversal(const MeasuredResponse& response, const std::string& reference) {
  std::vector<UniversalResponse> responses;
  const std::vector<double>& frequencies = response.response.frequency_Hz;
  for (const ChannelResponse& channel : response.response.channels) {
    UniversalResponse& one = responses.emplace_back(UniversalResponse{channel.name, channel.unit, channel.response});
    for (std::size_t i = 0; i < frequencies.size() && channel.unit == "m/s^2"; ++i)
      one.values[i] *= -std::pow(2 * std::numbers::pi * frequencies[i], 2);
  }
  return UniversalBytes(frequencies, reference, responses);
}

std::string MeasuredSvg(const MeasuredResponse& response, ExcitationKind kind) {
  const bool has_coherence = kind == ExcitationKind::kSweep || kind == ExcitationKind::kRandom;
  SvgSheet sheet{.title = "Response to the posts: " + response.name,
                 .note = "from a " + KindInWords(kind) + ", relative to the reference post",
                 .legend = {Measured(), Bounds()},
                 .columns = {"gain [dB]", "phase [deg]"},
                 .panel_width = 260,
                 .x_label = "frequency [Hz]",
                 .rows = {}};
  if (has_coherence) sheet.columns.push_back("coherence");
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const ChannelResponse& channel = response.response.channels[c];
    const std::vector<double>& frequency = response.response.frequency_Hz;
    SvgRow row{.title = channel.name, .note = GainReference(channel.unit), .panels = {}};
    row.panels = {GainPanel(frequency, channel), PhasePanel(frequency, channel)};
    if (has_coherence) row.panels.push_back(CoherencePanel(frequency, response.channels[c]));
    sheet.rows.push_back(std::move(row));
  }
  return SvgText(sheet);
}

std::string StudySection(const MeasuredResponses& measured) {
  std::string text = "recordings:\n";
  double lower_Hz = std::numeric_limits<double>::infinity();
  double upper_Hz = 0;
  for (const MeasuredResponse& response : measured.responses) {
    text +=
        "  - {file: " + response.name + ".csv, posts: " + response.pattern.value_or(Shares(measured, response)) + "}\n";
    lower_Hz = std::min(lower_Hz, response.response.frequency_Hz.front());
    upper_Hz = std::max(upper_Hz, response.response.frequency_Hz.back());
  }
  text += "# sensor of the vehicle: channel of the recordings\nchannels:\n";
  for (const ChannelResponse& channel : measured.responses.front().response.channels)
    text += "  " + channel.name + ": " + channel.name + "\n";
  // Outwards, so that the band holds the first and the last frequency.
  text += "band: [" + FormatNumber(std::floor(1e3 * lower_Hz) / 1e3) + " Hz, " +
          FormatNumber(std::ceil(1e3 * upper_Hz) / 1e3) + " Hz]\n";
  return text;
}

std::string MeasuredText(const MeasuredResponses& measured) {
  std::string text = FoundText(measured);
  for (const std::string& done : measured.preparations) text += done + '\n';
  for (const std::string& missed : measured.missed) text += missed + '\n';
  for (const MeasuredResponse& response : measured.responses) text += '\n' + ResponseText(measured, response);
  if (!measured.left_out.empty()) {
    std::string names;
    for (const std::string& name : measured.left_out) names += (names.empty() ? "" : ", ") + name;
    text += "\nleft out, as no length, force, acceleration or angular velocity: " + names + '\n';
  }
  return text;
}

nlohmann::ordered_json MeasuredJson(const MeasuredResponses& measured) {
  constexpr std::array<const char*, 4> kKinds = {"stepped", "sweep", "random", "multisine"};
  const bool is_stepped = measured.kind == ExcitationKind::kStepped;
  const bool is_multisine = measured.kind == ExcitationKind::kMultisine;
  Json responses = Json::array();
  for (const MeasuredResponse& response : measured.responses) {
    Json posts = Json::object();
    for (std::size_t p = 0; p < measured.posts.size(); ++p) posts[measured.posts[p]] = response.shares.share[p];
    responses.push_back({{"name", response.name},
                         {"pattern", response.pattern ? Json(*response.pattern) : Json()},
                         {"posts", posts},
                         {"reference", measured.posts[response.shares.reference]},
                         {"off_pattern", response.shares.rest},
                         {"frequency_Hz", response.response.frequency_Hz},
                         {"post_amplitude_m", response.response.amplitude_m},
                         {"repeats", response.repeats},
                         {"channels", ChannelsJson(response)}});
  }
  return {{"kind", kKinds[static_cast<std::size_t>(measured.kind)]},
          {"duration_s", measured.duration_s},
          {"rate_Hz", measured.rate_Hz},
          {"dwells", is_stepped ? Json(measured.dwells) : Json()},
          {"unsettled", is_stepped ? Json(measured.unsettled) : Json()},
          {"averages", is_stepped || is_multisine ? Json() : Json{measured.least_averages, measured.most_averages}},
          {"period_s", is_multisine ? Json(measured.period_s) : Json()},
          {"periods", is_multisine ? Json(measured.periods) : Json()},
          {"responses", responses},
          {"left_out", measured.left_out},
          {"preparation", measured.preparations},
          {"missed", measured.missed}};
}

}  // namespace fourpost
