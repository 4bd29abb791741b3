#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fourpost {

/// The period of a signal that repeats itself, in samples, a whole number; three periods at least. The shortest lag,
/// longer than 16 samples, at which the signal's autocorrelation comes as near to what it is at none as anywhere,
/// within what noise takes from it, and to `kept` of it at least. Nothing where there is none, or where it is not a
/// whole number of samples within a tenth of a sample over the record and what noise moves the peak by.
std::optional<std::size_t> PeriodOf(std::span<const double> signal, double kept = 0.9);

/// A channel's response at the excited lines.
struct LineResponse {
  std::vector<std::complex<double>> response;
  /// Of noise alone, and with the distortion that the response to other amplitudes and phases would have as well.
  std::vector<double> noise_variance;
  std::vector<double> variance;
  /// Root mean squares over the band, as shares of the channel's excited lines: noise of one period; what the excited
  /// lines bring forth at odd and at even lines that are not excited. NaN without such lines.
  double noise = 0;
  double odd_distortion = 0;
  double even_distortion = 0;
};

struct MultisineResponse {
  std::size_t period = 0;
  /// Whole periods that were used, and those before them that were left out.
  std::size_t periods = 0;
  std::size_t run_in = 0;
  bool is_settled = true;
  /// Excited lines, in cycles per period, and their amplitudes in the reference.
  std::vector<std::size_t> lines;
  std::vector<double> amplitude;
  std::vector<LineResponse> channels;
};

/// Responses to a periodic signal: the spectrum of each whole period, their means and scatter (Pintelon and Schoukens,
/// System Identification, 2nd ed., sections 2.5 and 4.3). A line is excited that exceeds a tenth of the largest within
/// a quarter of its frequency, a thousandth of the largest of all, and its own noise by 20 dB. Between excited lines a
/// linear system answers with nothing: what is there beyond noise, less what the reference itself has there, is
/// distortion; that of odd lines is also at the excited ones and adds to their variance. The run-in is cut by
/// SettledPartOf() over periods. Nothing of fewer than three periods, or without a line.
std::optional<MultisineResponse> RespondToMultisine(std::span<const double> reference,
                                                    std::span<const std::span<const double>> channels,
                                                    std::size_t period);

}  // namespace fourpost
