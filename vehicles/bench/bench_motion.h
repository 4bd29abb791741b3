#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// How a bench moves a damper: its extension x from mid-stroke [m] with rate and acceleration, at even steps, from the
/// first sample of a recording to the last.
struct BenchMotion {
  double step_s = 0;
  /// Steps from one sample of the recording to the next.
  std::size_t steps = 1;
  std::vector<double> extension;
  std::vector<double> rate;
  std::vector<double> acceleration;

  std::size_t samples() const { return extension.empty() ? 0 : (extension.size() - 1) / steps + 1; }
};

/// Motion through recorded displacements by the cubic spline of continuous curvature (UniformSpline), with the slopes
/// of the cubic through four samples at both ends: a differentiator without delay, whose rate at the samples errs by
/// (w h)^4 / 180 of itself, 1e-4 at 30 Hz sampled at 500 Hz, its acceleration by (w h)^2 / 12. Steps are of 1 ms at the
/// most, and whole fractions of a sample. Throws std::invalid_argument as UniformSpline does.
BenchMotion MotionThrough(std::span<const double> displacement, double sample_s);

/// The same through the same samples.
BenchMotion WithHalfTheStep(const BenchMotion& motion);

}  // namespace fourpost
