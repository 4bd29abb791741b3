#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// A causal Butterworth low-pass filter for samples at a fixed rate: second-order sections of the bilinear transform
/// with the cut-off prewarped (Oppenheim and Schafer, Discrete-Time Signal Processing, section 7.2), so that its gain
/// at the cut-off is 1/sqrt(2) exactly and 1 at rest. It starts at rest, with all samples before the first zero.
class LowPass {
 public:
  /// y[n] = b0 x[n] + b1 x[n-1] + b2 x[n-2] - a1 y[n-1] - a2 y[n-2].
  struct Section {
    double b0 = 1;
    double b1 = 0;
    double b2 = 0;
    double a1 = 0;
    double a2 = 0;
  };

  /// Throws std::invalid_argument unless order is 1 to 16 and 0 < cutoff_Hz < rate_Hz / 2.
  LowPass(int order, double cutoff_Hz, double rate_Hz);

  const std::vector<Section>& sections() const { return sections_; }

  /// What it makes of a sine, of that many cycles per sample: product over the sections of
  /// (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2), z = exp(2 pi i cycles).
  std::complex<double> Response(double cycles_per_sample) const;

  /// Samples within which its slowest pole fades to this share, above 0 and below 1: afterwards the filter has
  /// forgotten what was before.
  std::size_t SettlingSamples(double share) const;

  /// Replaces a signal by its filtered one.
  void Apply(std::span<double> signal) const;

 private:
  std::vector<Section> sections_;
};

}  // namespace fourpost
