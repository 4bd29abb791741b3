#pragma once

#include <vector>

namespace fourpost {

/// Frequencies at which spectra are taken, and their shares of an integral over the band:
///   integral of S df ~ sum over k of share_Hz[k] S(frequency_Hz[k]).
/// Gauss's rule of eight points on panels.
struct SpectralGrid {
  std::vector<double> frequency_Hz;
  std::vector<double> share_Hz;

  /// A band of a vehicle's response. Panels are as wide in ln f as resonances of this damping ratio let them, which are
  /// then integrated to about 1e-4; and short enough for the waves that a delay between posts makes in the spectra.
  /// `refinement`: divides the panels' widths, to see what the grid leaves. Throws std::invalid_argument naming the
  /// argument that is out of bounds.
  static SpectralGrid For(double lower_Hz, double upper_Hz, double longest_delay_s, double least_damping_ratio = 0.1,
                          double refinement = 1);

  std::size_t size() const { return frequency_Hz.size(); }
};

}  // namespace fourpost
