#include "vehicles/requests/sweep_files.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "analysis/charts/bode_panel.h"
#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/signals/decibel.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

double PhaseDeg(const std::complex<double>& value) { return DegreesFromRadians(std::arg(value)); }

Json DifferenceJson(const LargestDifference& difference) {
  return {{"value", difference.value}, {"channel", difference.channel}, {"frequency_Hz", difference.frequency_Hz}};
}

Json SweepJson(const SweptResponse& swept, const Vehicle& vehicle) {
  Json shares = Json::object();
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p) shares[vehicle.posts[p].name] = swept.excitation.shape[p];
  Json engines = Json::array();
  for (const Engine engine : swept.answer.engine_at) engines.push_back(EngineName(engine));
  Json unanswered = Json::array();
  for (const Unanswered& none : swept.answer.unanswered)
    unanswered.push_back({{"frequency_Hz", none.frequency_Hz}, {"why", none.why}});
  Json channels = Json::array();
  for (const ChannelResponse& channel : swept.answer.response.channels) channels.push_back(ChannelJson(channel));
  return {{"mode", swept.mode},
          {"posts", shares},
          {"engine", EngineName(swept.answer.engine)},
          {"linear_kinematics_error", KinematicsJson(swept.answer.kinematics_error, swept.answer.not_estimated)},
          {"frequency_Hz", swept.excitation.frequency_Hz},
          {"post_amplitude_m", swept.excitation.amplitude_m},
          {"engine_at", engines},
          {"unanswered", unanswered},
          {"channels", channels}};
}

double LargestGain(const ChannelResponse& channel) {
  double largest = 0;
  for (const std::complex<double>& value : channel.response)
    if (std::isfinite(std::abs(value))) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Of each unit the largest gain.
std::map<std::string, double> Loudest(const FrequencyResponse& response) {
  std::map<std::string, double> loudest;
  for (const ChannelResponse& channel : response.channels)
    loudest[channel.unit] = std::max(loudest[channel.unit], LargestGain(channel));
  return loudest;
}

// Two colours of Okabe and Ito that the colour-blind tell apart, and that differ in lightness.
SvgStyle Answered() { return {.label = "modelled", .color = "#0072B2", .mark = SvgMark::kLine}; }
SvgStyle Linear() { return {.label = "linear kinematics", .color = "#E69F00", .mark = SvgMark::kLine}; }

/// Panels of one channel, gain and phase of each mode.
SvgRow RowOf(std::size_t channel, const std::vector<SweptResponse>& responses) {
  constexpr double kSilent = 1e-6;
  std::vector<SvgPanel> gains;
  std::vector<SvgPanel> phases;
  for (const SweptResponse& swept : responses) {
    const std::vector<double>& frequency = swept.excitation.frequency_Hz;
    SvgPanel gain{.x = FrequencyAxis(frequency.front(), frequency.back())};
    SvgPanel phase = gain;
    const ChannelResponse& answer = swept.answer.response.channels[channel];
    if (LargestGain(answer) > kSilent * Loudest(swept.answer.response)[answer.unit]) {
      if (swept.answer.linearised) {
        const ChannelResponse& linear = swept.answer.linearised->channels[channel];
        gain.series.push_back(GainSeries(frequency, linear.response, Linear()));
        phase.series.push_back(PhaseSeries(frequency, linear.response, Linear()));
      }
      gain.series.push_back(GainSeries(frequency, answer.response, Answered()));
      phase.series.push_back(PhaseSeries(frequency, answer.response, Answered()));
    }
    gains.push_back(std::move(gain));
    phases.push_back(std::move(phase));
  }
  const ChannelResponse& first = responses.front().answer.response.channels[channel];
  SvgRow row{.title = first.name, .note = GainReference(first.unit)};
  const ChartAxis gain_axis = GainAxis(gains);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    gains[i].y = gain_axis;
    phases[i].y = PhaseAxis();
    row.panels.push_back(gains[i]);
    row.panels.push_back(phases[i]);
  }
  return row;
}

}  // namespace

Json KinematicsJson(const std::optional<KinematicsError>& error, const std::string& not_estimated) {
  if (!error) return not_estimated.empty() ? Json() : Json{{"not_estimated", not_estimated}};
  return {{"gain_dB", DifferenceJson(error->gain_dB)},
          {"phase_deg", DifferenceJson(error->phase_deg)},
          {"visible", error->IsVisible()}};
}

std::string SweepCsv(const std::vector<SweptResponse>& responses) {
  CsvWriter csv({"mode", "channel", "unit", "frequency_Hz", "post_amplitude_m", "gain", "phase_deg", "mean",
                 "second_harmonic", "engine"});
  for (const SweptResponse& swept : responses)
    for (const ChannelResponse& channel : swept.answer.response.channels)
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        csv.Add(swept.mode).Add(channel.name).Add(channel.unit);
        csv.Add(swept.excitation.frequency_Hz[i]).Add(swept.excitation.amplitude_m[i]);
        csv.Add(std::abs(channel.response[i])).Add(PhaseDeg(channel.response[i]));
        csv.Add(channel.mean[i]).Add(channel.second_harmonic[i]).Add(EngineName(swept.answer.engine_at[i]));
      }
  return csv.text();
}

std::string SweepJson(const Vehicle& vehicle, const SweepRequest& request, const std::vector<SweptResponse>& responses,
                      const Diagnostics& findings) {
  const auto limit = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json modes = Json::array();
  for (const SweptResponse& swept : responses) modes.push_back(SweepJson(swept, vehicle));
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  const Json json = {{"vehicle", vehicle.name},
                     {"parameters", parameters},
                     {"direction", request.falling ? "down" : "up"},
                     {"amplitude_law",
                      {{"displacement_m", limit(request.amplitude.displacement_m)},
                       {"velocity_m_per_s", limit(request.amplitude.velocity_mps)},
                       {"acceleration_m_per_s2", limit(request.amplitude.acceleration_mps2)}}},
                     {"modes", modes},
                     {"findings", FindingsJson(findings)},
                     {"versions", versions}};
  return JsonText(json);
}

std::string SweepSvg(const std::string& vehicle, const std::vector<SweptResponse>& responses) {
  SvgSheet sheet{.title = "Response of " + vehicle + " to the posts",
                 .note = "gain and phase of the first harmonic, relative to the reference post",
                 .legend = {Answered()},
                 .x_label = "frequency [Hz]"};
  const auto is_full = [](const SweptResponse& swept) { return swept.answer.linearised.has_value(); };
  if (std::any_of(responses.begin(), responses.end(), is_full)) sheet.legend.push_back(Linear());
  for (const SweptResponse& swept : responses) {
    sheet.columns.push_back(swept.mode + ": gain [dB]");
    sheet.columns.push_back(swept.mode + ": phase [deg]");
  }
  for (std::size_t c = 0; c < responses.front().answer.response.channels.size(); ++c)
    sheet.rows.push_back(RowOf(c, responses));
  return SvgText(sheet);
}

}  // namespace fourpost
