#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace fourpost {

/// Samples of a sum of sines, evenly spaced in frequency by 1 / (count step), count a power of two.
struct SineGrid {
  double step_s = 0;
  std::size_t count = 0;

  /// Enough for a duration, with 64 samples per period of the highest frequency.
  static SineGrid For(double upper_Hz, double duration_s);

  double spacing_Hz() const { return 1 / (step_s * static_cast<double>(count)); }
};

/// sum over k of Re(phasor(f_k) exp(2 pi i f_k t)) at the grid's times, f_k all multiples of its spacing from lower to
/// upper; the phasors are asked for in rising order.
std::vector<double> SumOfSines(const SineGrid& grid, double lower_Hz, double upper_Hz,
                               const std::function<std::complex<double>(double frequency_Hz)>& phasor);

/// Keeps the samples up to a duration and lets them grow from zero and fade to it, over a second or a quarter of them.
std::vector<double> Faded(std::vector<double> samples, double step_s, double duration_s);

}  // namespace fourpost
