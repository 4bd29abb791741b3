#include "vehicles/bench/bench_motion.h"

#include <cmath>

#include "analysis/signals/spline_through.h"

namespace fourpost {
namespace {

constexpr double kLongestStep_s = 1e-3;

BenchMotion InSteps(std::span<const double> displacement, double sample_s, std::size_t steps) {
  const UniformSpline spline = SplineThrough(displacement, 0, sample_s);
  BenchMotion motion;
  motion.steps = steps;
  motion.step_s = sample_s / static_cast<double>(motion.steps);
  const std::size_t count = (displacement.size() - 1) * motion.steps + 1;
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

}  // namespace

BenchMotion MotionThrough(std::span<const double> displacement, double sample_s) {
  // A step that is the longest but for rounding does not need another one.
  return InSteps(displacement, sample_s, static_cast<std::size_t>(std::ceil(sample_s / kLongestStep_s - 1e-9)));
}

BenchMotion WithHalfTheStep(const BenchMotion& motion) {
  std::vector<double> displacement;
  for (std::size_t k = 0; k < motion.extension.size(); k += motion.steps) displacement.push_back(motion.extension[k]);
  return InSteps(displacement, motion.step_s * static_cast<double>(motion.steps), 2 * motion.steps);
}

}  // namespace fourpost
