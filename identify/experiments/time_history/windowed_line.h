#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// One line of spectra of signals that are related by derivatives: by Hann's window w, w = w' = 0 at its ends, the line
/// of a derivative is by parts that of the signal under the derivative of w(t) exp(-i omega t), without a leak,
///   int w x' e dt = -int (w e)' x dt,  int w x'' e dt = int (w e)'' x dt,
/// so that acceleration, speed and displacement of one motion agree whatever the motion is (modulating functions:
/// Shinbrot 1957). Amplitudes are those of a sine.
class WindowedLine {
 public:
  /// Of so many samples.
  WindowedLine(std::size_t samples, double rate_Hz, double frequency_Hz);

  /// Of the derivative of this order, 0 to 2.
  std::complex<double> Of(std::span<const double> signal, int derivative) const;

  /// Standard deviation of its real part that white noise of a deviation brings, without a derivative.
  double NoiseSd(double noise_sd) const;

 private:
  /// Of derivatives 0, 1, 2.
  std::vector<std::complex<double>> factor_[3];
  double noise_ = 0;
};

}  // namespace fourpost
