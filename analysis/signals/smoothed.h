#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// A signal without the white noise in it.
struct Smoothed {
  std::vector<double> signal;
  /// Standard deviation of what was taken out [its unit]; 0 where nothing was.
  double noise = 0;
};

/// The signal of least squares of its third differences beside its distance from the samples (Whittaker 1923,
/// doi:10.1017/S0013091500077853), their weight such that each sample would be predicted best by all others:
/// generalised cross-validation (Craven and Wahba 1979, doi:10.1007/BF01404567). No delay; a cut-off of sixth order.
/// A signal that does not have white noise, or is shorter than 64 samples, comes back as it is.
Smoothed WithoutNoise(std::span<const double> signal);

}  // namespace fourpost
