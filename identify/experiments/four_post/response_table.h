#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// Measured and modelled response of a channel in one recording, as in response.csv: one entry per frequency, NaN where
/// there is none. Vectors that the file has no column for are empty.
struct ComparedChannel {
  std::string recording;
  std::string name;
  std::string unit;
  std::vector<double> frequency_Hz;
  std::vector<double> post_amplitude_m;
  std::vector<bool> in_band;
  std::vector<double> gain_measured;
  std::vector<double> gain_modelled;
  std::vector<double> gain_start;
  /// Standard deviation of the repeats.
  std::vector<double> gain_sd;
  std::vector<double> phase_measured_deg;
  std::vector<double> phase_modelled_deg;
  std::vector<double> phase_start_deg;
  std::vector<double> phase_sd_deg;
  /// Half widths of bands of 95 % about the model: of the parameters, and of new measured points.
  std::vector<double> gain_band;
  std::vector<double> gain_band_measured;
  std::vector<double> phase_band_deg;
  std::vector<double> phase_band_measured_deg;
  std::vector<double> mean_measured;
  std::vector<double> mean_modelled;
};

/// Reads a response.csv. Throws FaultyInput.
std::vector<ComparedChannel> ReadResponseTable(const std::string& text, const std::string& file);

}  // namespace fourpost
