#include "identify/command_line/response_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/text/text_table.h"
#include "vehicles/requests/amplitude_limits.h"
#include "vehicles/requests/engine_text.h"

namespace fourpost {
namespace {

/// Gains are per metre of the post, those of displacements and accelerations plain ratios.
std::string GainUnit(const std::string& unit) { return unit == "m" || unit == "m/s^2" ? "1" : unit + "/m"; }

/// All of few frequencies; of many eight, spread over the band evenly in octaves.
std::vector<std::size_t> ShownFrequencies(const std::vector<double>& frequency_Hz) {
  constexpr std::size_t kMost = 10;
  constexpr int kSpread = 8;
  std::vector<std::size_t> shown;
  if (frequency_Hz.size() <= kMost) {
    for (std::size_t i = 0; i < frequency_Hz.size(); ++i) shown.push_back(i);
    return shown;
  }
  for (int k = 0; k < kSpread; ++k) {
    const double octaves = std::log(frequency_Hz.back() / frequency_Hz.front()) * k / (kSpread - 1);
    const double wanted = frequency_Hz.front() * std::exp(octaves);
    const auto nearest = std::min_element(frequency_Hz.begin(), frequency_Hz.end(), [&](double a, double b) {
      return std::abs(std::log(a / wanted)) < std::abs(std::log(b / wanted));
    });
    const auto index = static_cast<std::size_t>(nearest - frequency_Hz.begin());
    if (shown.empty() || index > shown.back()) shown.push_back(index);
  }
  return shown;
}

std::string Gain(double value, int digits) { return std::isfinite(value) ? Rounded(value, digits) : "-"; }

std::vector<std::string> ChannelRow(const ChannelResponse& channel, const std::vector<double>& frequency_Hz) {
  std::size_t peak = channel.response.size();
  for (std::size_t i = 0; i < channel.response.size(); ++i)
    if (std::isfinite(std::abs(channel.response[i])) &&
        (peak == channel.response.size() || std::abs(channel.response[i]) > std::abs(channel.response[peak])))
      peak = i;
  const bool any = peak < channel.response.size();
  std::vector<std::string> row = {channel.name, GainUnit(channel.unit),
                                  any ? Rounded(std::abs(channel.response[peak]), 4) : "-",
                                  any ? Rounded(frequency_Hz[peak], 3) : "-"};
  for (const std::size_t i : ShownFrequencies(frequency_Hz)) row.push_back(Gain(std::abs(channel.response[i]), 3));
  return row;
}

std::string GainTable(const SweptResponse& swept) {
  std::vector<std::string> head = {"gain", "unit", "peak", "at Hz"};
  for (const std::size_t i : ShownFrequencies(swept.excitation.frequency_Hz))
    head.push_back(Rounded(swept.excitation.frequency_Hz[i], 3) + " Hz");
  TextTable table(head);
  for (const ChannelResponse& channel : swept.answer.response.channels)
    table.Add(ChannelRow(channel, swept.excitation.frequency_Hz));
  return table.Format();
}

/// What linear kinematics leave out, and what follows from it.
std::string CheckText(const SteadyResponse& answer) {
  if (!answer.not_estimated.empty()) return "error of linear kinematics not estimated: " + answer.not_estimated + "\n";
  if (!answer.kinematics_error) return "";
  const KinematicsError& error = *answer.kinematics_error;
  return KinematicsText(error) + (error.IsVisible() ? ":\nabove" : ":\nbelow") + " the visible limit (" +
         Rounded(kVisible_dB, 1) + " dB, " + Rounded(kVisible_deg, 1) +
         " deg): " + (error.IsVisible() ? "full geometry used\n" : "reduced model used\n");
}

std::string Heading(const SweptResponse& swept, const SweepRequest& request) {
  const std::vector<double>& frequency = swept.excitation.frequency_Hz;
  return swept.mode + ": " + std::to_string(frequency.size()) + " frequencies from " + Rounded(frequency.front(), 3) +
         " to " + Rounded(frequency.back(), 3) + " Hz, swept " + (request.falling ? "down" : "up") + ", engine " +
         EngineName(swept.answer.engine) + "\nthe reference post moves at most " + LimitsText(request.amplitude) + "\n";
}

/// Neighbours of one cause in one line.
std::string WhyUnanswered(const SteadyResponse& answer) {
  std::string text;
  for (std::size_t i = 0; i < answer.unanswered.size();) {
    const std::string& why = answer.unanswered[i].why;
    text += "no answer at " + Rounded(answer.unanswered[i].frequency_Hz, 3);
    for (++i; i < answer.unanswered.size() && answer.unanswered[i].why == why; ++i)
      text += ", " + Rounded(answer.unanswered[i].frequency_Hz, 3);
    text += " Hz: " + why + '\n';
  }
  return text;
}

}  // namespace

std::string ResponseText(const SweepRequest& request, const std::vector<SweptResponse>& responses) {
  std::string text;
  for (const SweptResponse& swept : responses)
    text += (text.empty() ? "" : "\n") + Heading(swept, request) + CheckText(swept.answer) + GainTable(swept) +
            WhyUnanswered(swept.answer);
  return text;
}

}  // namespace fourpost
