#include "vehicles/bench/bench_motion.h"

#include <cmath>

#include "analysis/uniform_spline.h"

namespace fourpost {
namespace {

constexpr double kLongestStep_s = 1e-3;

double SlopeAtEnd(std::span<const double> values, double step) {
  return -SlopeAtStart({values.rbegin(), values.rend()}, step);
}

}  // namespace

BenchMotion MotionThrough(std::span<const double> displacement, double sample_s) {
  const std::vector<double> values(displacement.begin(), displacement.end());
  const UniformSpline spline(0, sample_s, values, SlopeAtStart(values, sample_s), SlopeAtEnd(displacement, sample_s));
  BenchMotion motion;
  // A step that is the longest but for rounding does not need another one.
  motion.steps = static_cast<std::size_t>(std::ceil(sample_s / kLongestStep_s - 1e-9));
  motion.step_s = sample_s / static_cast<double>(motion.steps);
  const std::size_t count = (values.size() - 1) * motion.steps + 1;
  motion.extension.reserve(count);
  motion.rate.reserve(count);
  motion.acceleration.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const UniformSpline::Point point = spline.At(motion.step_s * static_cast<double>(k));
    motion.extension.push_back(point.value);
    motion.rate.push_back(point.slope);
    motion.acceleration.push_back(point.curvature);
  }
  return motion;
}

}  // namespace fourpost
