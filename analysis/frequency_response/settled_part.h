#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// The part of a series of blocks that is stationary.
struct SettledPart {
  /// The first block of it.
  std::size_t first = 0;
  /// False where the second half, too, begins off its end, by more than 0.04 dB over the root of the number of blocks.
  bool is_settled = true;
};

/// Cuts the run-in of phasors by blocks, of one or several signals: blocks are left out from the first on until in
/// every signal the mean of the next 1, 2, 4, ... blocks, and of half of what is left, equals the mean of the last half
/// within what their scatter allows (chi-square of two degrees of freedom, 0.1 % over all signals and lengths
/// together). The scatter is that of the last half's differences from block to block, which a slow drift does not
/// enlarge, and at least a thousandth of the mean phasor over the root of the number of blocks: 0.01 dB. The first
/// block of four and more is always left out. Half of the blocks stay at least.
SettledPart SettledPartOf(std::span<const std::vector<std::complex<double>>> signals);

/// Variance of the mean of a series of complex numbers, real and imaginary part together, whose neighbours may be
/// correlated: the larger one of their scatter, as if independent, and of the spectral density next to frequency zero,
/// from the lowest Fourier lines, a sixth of all and four at most, where these are three at least (Bendat and Piersol,
/// Random Data, 4th ed., section 8.5; the density at zero is the variance of the mean times the number). Without such
/// lines it is larger by Student's distribution: 1.96 of its roots hold 95 %, although few numbers know their scatter
/// poorly. Of fewer than three numbers NaN.
double VarianceOfMean(std::span<const std::complex<double>> series);

/// The same of real numbers, n of which have n - 1 degrees of freedom where complex ones have 2 n - 2: Student's
/// distribution for any number of them. Lines of both signs are one and the same.
double VarianceOfMean(std::span<const double> series);

/// By which Student's distribution enlarges a variance that is known by that many degrees of freedom, for 95 %.
double StudentFactor(double degrees_of_freedom);

}  // namespace fourpost
