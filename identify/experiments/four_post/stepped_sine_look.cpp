#include "identify/experiments/four_post/stepped_sine_look.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/frequency_response_file.h"
#include "analysis/files/recording_layout.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Root mean square of the deviations over repeats, as shares of the gain; NaN where there are none.
double NoiseOf(const ChannelResponse& channel) {
  double sum = 0;
  for (std::size_t i = 0; i < channel.gain_sd.size(); ++i)
    sum += std::pow(channel.gain_sd[i] / std::abs(channel.response[i]), 2);
  return channel.gain_sd.empty() ? std::nan("") : std::sqrt(sum / static_cast<double>(channel.gain_sd.size()));
}

struct GainRange {
  double least = 0;
  double most = 0;
};

GainRange GainsOf(const ChannelResponse& channel) {
  GainRange range = {std::abs(channel.response.front()), 0};
  for (const std::complex<double>& response : channel.response) {
    range.least = std::min(range.least, std::abs(response));
    range.most = std::max(range.most, std::abs(response));
  }
  return range;
}

/// Accelerations are given relative to that of the post.
std::string GainUnit(const ChannelResponse& channel) {
  return channel.unit == "m/s^2" ? "1" : channel.unit == "m" ? "m/m" : channel.unit + "/m";
}

std::string AmplitudeText(const FrequencyResponse& response, bool has_amplitude) {
  if (!has_amplitude) return "post amplitude not stated: state it in the study, as in amplitude: 5 mm";
  const auto [least, most] = std::minmax_element(response.amplitude_m.begin(), response.amplitude_m.end());
  return "post amplitude " + Rounded(1e3 * *least, 3) + " to " + Rounded(1e3 * *most, 3) + " mm";
}

std::string TextOf(const FrequencyResponse& response, bool has_amplitude) {
  std::string text = "stepped sine, " + std::to_string(response.frequency_Hz.size()) + " frequencies from " +
                     Rounded(response.frequency_Hz.front(), 4) + " to " + Rounded(response.frequency_Hz.back(), 4) +
                     " Hz, " + AmplitudeText(response, has_amplitude) + '\n';
  TextTable table({"channel", "gain", "minimum", "maximum", "sd of repeats", "mean offset"});
  for (const ChannelResponse& channel : response.channels) {
    const GainRange range = GainsOf(channel);
    const double noise = NoiseOf(channel);
    table.Add({channel.name, GainUnit(channel), Rounded(range.least, 3), Rounded(range.most, 3),
               std::isnan(noise) ? "none" : Rounded(100 * noise, 2) + " %", channel.mean.empty() ? "no" : "yes"});
  }
  return text + table.Format();
}

Json JsonOf(const FrequencyResponse& response, bool has_amplitude) {
  Json channels = Json::array();
  for (const ChannelResponse& channel : response.channels) {
    const GainRange range = GainsOf(channel);
    const double noise = NoiseOf(channel);
    channels.push_back({{"name", channel.name},
                        {"gain_unit", GainUnit(channel)},
                        {"least_gain", range.least},
                        {"most_gain", range.most},
                        {"gain_sd_share", std::isnan(noise) ? Json() : Json(noise)},
                        {"has_mean", !channel.mean.empty()}});
  }
  return {{"kind", "stepped_sine"},
          {"frequency_Hz", response.frequency_Hz},
          {"post_amplitude_m", has_amplitude ? Json(response.amplitude_m) : Json()},
          {"channels", channels}};
}

std::optional<RecordingLook> LookAt(const std::filesystem::path& file, const RecordedTable& table,
                                    Diagnostics& faults) {
  // That of universal files is known to the study alone; what the table itself lacked has been reported.
  const bool has_amplitude = table.FindColumn("post_amplitude_m") || table.names_line() > 0;
  Diagnostics found;
  const std::optional<FrequencyResponse> response =
      ReadFrequencyResponse(file, found, has_amplitude ? std::nullopt : std::optional(1.0));
  for (const Diagnostic& finding : found.items())
    if (finding.severity == Severity::kError) faults.Add(finding);
  if (!response) return std::nullopt;
  return RecordingLook{TextOf(*response, has_amplitude), JsonOf(*response, has_amplitude)};
}

}  // namespace

const RecordingViewer kSteppedSineViewer{.takes = &IsSteppedSine, .look = &LookAt};

}  // namespace fourpost
