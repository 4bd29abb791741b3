#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/signals/decibel.h"
#include "analysis/signals/frequency_response.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/amplitude_law.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// By how much a balance may differ from the march.
inline constexpr double kAccepted_dB = 0.02;
inline constexpr double kAccepted_deg = 0.1;

/// The rig's amplitudes, and what they are taken times.
inline constexpr AmplitudeLaw kRigLaw = {.displacement_m = 0.012, .velocity_mps = 0.15, .acceleration_mps2 = 6};
inline constexpr std::array<double, 3> kAcceptedScales = {0.25, 1, 2};

/// `first`, `first` + `every`, ... of 40 frequencies from 0.5 to 30 Hz, evenly spaced in their logarithm.
inline Excitation AcceptanceSine(const Vehicle& vehicle, std::string_view pattern, double scale, std::size_t first = 0,
                                 std::size_t every = 1) {
  constexpr std::size_t kCount = 40;
  Excitation excitation{.shape = PostPattern(vehicle, pattern)};
  for (std::size_t i = first; i < kCount; i += every) {
    const double frequency = 0.5 * std::pow(60, static_cast<double>(i) / (kCount - 1));
    excitation.frequency_Hz.push_back(frequency);
    excitation.amplitude_m.push_back(scale * kRigLaw.At(frequency));
  }
  return excitation;
}

/// A deviation, and where it is.
struct DeviationAt {
  double value = 0;
  double frequency_Hz = 0;
  std::string channel;

  void Take(double other, double at_Hz, const std::string& of) {
    if (!(other <= value)) *this = {other, at_Hz, of};
  }
};

struct EngineDeviation {
  DeviationAt gain_dB;
  DeviationAt phase_deg;
  /// Channels compared; the others are silent.
  int channels = 0;
};

/// Largest deviations of gain and phase from a reference, over the channels that are not silent: whose largest value is
/// a hundredth of the loudest of their unit or more, and of 1 m/m, 1 (m/s^2)/(m/s^2) or 1 (rad/s)/m. No frequency is
/// left out; but as next to a node a ratio says nothing, a value below 3 % of its channel's largest counts its
/// difference as a share of these 3 %.
inline EngineDeviation DeviationOf(const FrequencyResponse& balance, const FrequencyResponse& reference) {
  constexpr double kSilent = 0.01;
  constexpr double kNode = 0.03;
  const auto largest = [](const ChannelResponse& channel) {
    double out = 0;
    for (const std::complex<double>& value : channel.response) out = std::max(out, std::abs(value));
    return out;
  };
  std::map<std::string, double> loudest;
  for (const ChannelResponse& channel : reference.channels)
    loudest[channel.unit] = std::max({1.0, loudest[channel.unit], largest(channel)});
  EngineDeviation out;
  for (std::size_t c = 0; c < reference.channels.size(); ++c) {
    const ChannelResponse& channel = reference.channels[c];
    const double most = largest(channel);
    if (most < kSilent * loudest[channel.unit]) continue;
    ++out.channels;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const std::complex<double> value = channel.response[i];
      const std::complex<double> difference = balance.channels[c].response[i] - value;
      const std::complex<double> ratio =
          1.0 + difference / (std::abs(value) < kNode * most ? std::polar(kNode * most, std::arg(value)) : value);
      out.gain_dB.Take(std::abs(DecibelFromGain(std::abs(ratio))), reference.frequency_Hz[i], channel.name);
      out.phase_deg.Take(std::abs(DegreesFromRadians(std::arg(ratio))), reference.frequency_Hz[i], channel.name);
    }
  }
  return out;
}

}  // namespace fourpost
