#pragma once

#include <complex>
#include <string>
#include <vector>

namespace fourpost {

/// One channel of a frequency response; every non-empty vector has one entry per frequency.
struct ChannelResponse {
  std::string name;
  /// Unit of the channel itself ("m", "N", "m/s^2", "rad/s"); responses are per unit of the reference.
  std::string unit;
  /// Response relative to the reference post: its displacement, or for accelerometers its acceleration.
  std::vector<std::complex<double>> response;
  /// Standard deviations over repeats; empty for a model.
  std::vector<double> gain_sd;
  std::vector<double> phase_sd_rad;
  /// Mean offset from rest, in the channel's unit; empty where not measured.
  std::vector<double> mean;
  /// Its standard deviation; empty where not known, and for a model.
  std::vector<double> mean_sd;
  /// Amplitude of the second harmonic, in the channel's unit; empty where not measured.
  std::vector<double> second_harmonic;
};

/// Response to a stepped sine: measured or modelled.
struct FrequencyResponse {
  std::vector<double> frequency_Hz;
  /// Amplitude of the posts at each frequency.
  std::vector<double> amplitude_m;
  std::vector<ChannelResponse> channels;

  /// Null when there is no such channel.
  const ChannelResponse* Find(const std::string& channel) const;
};

}  // namespace fourpost
