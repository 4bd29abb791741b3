#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// A sine with harmonics and a straight drift, fitted to samples by least squares.
struct SineFit {
  /// y(t) = Re sum_h phasor[h - 1] exp(i h w t) + mean + drift: phasors of harmonics 1, 2, ..., at the first sample, in
  /// the unit of the samples.
  std::vector<std::complex<double>> phasor;
  /// At the middle of the samples.
  double mean = 0;
  /// From the first sample to the last one.
  double drift = 0;
};

/// Fits signals of one length to samples first..last (the last excluded). `origin`: the sample at which phases count,
/// so that parts of a record compare. `harmonics`, at least 1, are cut to those below 0.45 cycles per sample. A
/// straight drift, fitted along, would else leak into the fundamental by 1 / (pi cycles) of its size. Throws
/// std::invalid_argument for fewer samples than unknowns and for frequencies that are not in (0, 0.45).
std::vector<SineFit> FitSines(std::span<const std::span<const double>> signals, std::size_t first, std::size_t last,
                              double cycles_per_sample, int harmonics, double origin);

/// Phasors over blocks of whole cycles, one column of them per signal.
struct CyclePhasors {
  /// Of each block, and one behind the last.
  std::vector<std::size_t> start;
  /// Of the fundamental: of each signal one per block.
  std::vector<std::vector<std::complex<double>>> phasor;
  /// Of each signal one per block, in its unit.
  std::vector<std::vector<double>> offset;
  /// Of a block.
  int cycles = 1;

  std::size_t blocks() const { return start.size() - 1; }
};

/// Blocks from sample `first` on that end before `last`: of one cycle each, or of as many as have 16 samples. Each is a
/// fit of offset and fundamental.
CyclePhasors PhasorsByCycle(std::span<const std::span<const double>> signals, double first, double last,
                            double cycles_per_sample, double origin);

/// The frequency at which the phasors of blocks turn no more: that of a sine in samples first..last of a signal that is
/// known to a tenth of a cycle over them. Iterates on the slope of the phase, weighted as least squares.
double RefinedFrequency(std::span<const double> signal, double first, double last, double cycles_per_sample);

}  // namespace fourpost
