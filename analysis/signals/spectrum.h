#pragma once

#include <complex>
#include <span>
#include <vector>

namespace fourpost {

/// Power over frequency of one or two signals by Welch's method (IEEE Trans. Audio Electroacoustics 15, 1967): mean
/// over segments that overlap by half, each without its mean and under Hann's window (periodic), one-sided, as
/// scipy.signal.welch, csd and coherence have it.
struct Spectrum {
  /// From 0 to half the rate.
  std::vector<double> frequency_Hz;
  /// [unit^2/Hz] of the first and the second signal, and of conj(first) second.
  std::vector<double> first;
  std::vector<double> second;
  std::vector<std::complex<double>> cross;

  /// |cross|^2 / (first second): 1 where the second follows linearly from the first, without noise; of one segment
  /// alone always.
  std::vector<double> Coherence() const;
};

/// Throws std::invalid_argument for signals of unlike length, for segments shorter than four samples or longer than the
/// signals, and for a rate that is not positive.
Spectrum WelchSpectrum(std::span<const double> first, std::span<const double> second, double rate_Hz,
                       std::size_t segment);

}  // namespace fourpost
