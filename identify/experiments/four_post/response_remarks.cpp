#include "identify/experiments/four_post/response_remarks.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"

namespace fourpost {
namespace {

/// The octave from this frequency on in which most of the band's misfit lies.
struct Octave {
  double lower_Hz = 0;
  std::string channel;
  double rms_dB = 0;
};

std::optional<Octave> WorstOctave(const std::vector<ComparedChannel>& channels) {
  std::optional<Octave> worst;
  for (const ComparedChannel& channel : channels) {
    std::map<int, std::pair<double, int>> squares;
    for (std::size_t i = 0; i < channel.frequency_Hz.size(); ++i) {
      if (!channel.in_band[i] || channel.phase_measured_deg.empty() || channel.phase_modelled_deg.empty()) continue;
      const auto phasor = [](double gain, double deg) { return std::polar(gain, deg * std::numbers::pi / 180); };
      const std::complex<double> measured = phasor(channel.gain_measured[i], channel.phase_measured_deg[i]);
      const std::complex<double> modelled = phasor(channel.gain_modelled[i], channel.phase_modelled_deg[i]);
      const double error = std::norm(modelled / measured - 1.0);
      if (!std::isfinite(error)) continue;
      auto& [sum, count] = squares[static_cast<int>(std::floor(std::log2(channel.frequency_Hz[i])))];
      sum += error;
      ++count;
    }
    for (const auto& [octave, tally] : squares) {
      const double rms = std::sqrt(tally.first / tally.second);
      if (tally.second >= 3 && (!worst || rms > worst->rms_dB)) worst = {std::exp2(octave), channel.name, rms};
    }
  }
  return worst;
}

bool IsForce(const ComparedChannel& channel) { return channel.unit == "N" || channel.unit == "kN"; }

bool HasMean(const ComparedChannel& channel) {
  return std::any_of(channel.mean_measured.begin(), channel.mean_measured.end(),
                     [](double mean) { return std::isfinite(mean); });
}

}  // namespace

ReportRemarks ResponseRemarks(const std::vector<ComparedChannel>& channels, bool is_wiring_cleared) {
  ReportRemarks remarks;
  if (channels.empty()) return remarks;
  remarks.measures_force = std::any_of(channels.begin(), channels.end(), IsForce);
  remarks.where_open =
      "Measure a force, static corner loads or the wheel pans: accelerations alone do not determine the common scale "
      "of masses, rates and damping.";
  if (std::none_of(channels.begin(), channels.end(), HasMean))
    remarks.further.emplace_back(
        "Record the mean offset of the struts as well as gain and phase: it separates bump from rebound damping.");
  const std::optional<Octave> worst = WorstOctave(channels);
  if (!worst) return remarks;
  const std::string channel = html::Code(worst->channel);
  remarks.worst = "The largest relative error is at " + channel + " between " + ShownShort(worst->lower_Hz, 3) +
                  " and " + ShownShort(2 * worst->lower_Hz, 3) + " Hz.";
  remarks.where_missed =
      (is_wiring_cleared ? "The audit suspects no channel, so at " + channel + " the model lacks a mechanism near "
                         : "Check the wiring of " + channel +
                               " (sign, scale, delay, position). If it is right, the model lacks a mechanism near ") +
      ShownShort(std::sqrt(2.0) * worst->lower_Hz, 2) + " Hz" +
      (worst->lower_Hz < 2
           ? ". Large errors in small slow strokes are typical of dry friction. Add friction, or test these "
             "frequencies at two amplitudes: friction makes the gain depend on amplitude."
           : ". Repeat the recording at another amplitude: a nonlinear law changes with it, a missing "
             "degree of freedom does not.");
  return remarks;
}

}  // namespace fourpost
