#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// Motion of a damper on a bench: extension x from mid-stroke [m], rate and acceleration, at equal steps, from the
/// first sample of a recording to the last.
struct BenchMotion {
  double step_s = 0;
  /// Steps per sample of the recording.
  std::size_t steps = 1;
  std::vector<double> extension;
  std::vector<double> rate;
  std::vector<double> acceleration;

  std::size_t samples() const { return extension.empty() ? 0 : (extension.size() - 1) / steps + 1; }
};

/// Motion through recorded displacements by the cubic spline of continuous curvature (UniformSpline), with the slopes
/// of the cubic through four samples at both ends. It differentiates without delay. The relative error at the samples
/// is (w h)^4 / 180 for the rate, 1e-4 at 30 Hz sampled at 500 Hz, and (w h)^2 / 12 for the acceleration. Steps are
/// whole fractions of a sample, 1 ms at most. Throws std::invalid_argument as UniformSpline does.
BenchMotion MotionThrough(std::span<const double> displacement, double sample_s);

/// The same through the same samples.
BenchMotion WithHalfTheStep(const BenchMotion& motion);

}  // namespace fourpost
