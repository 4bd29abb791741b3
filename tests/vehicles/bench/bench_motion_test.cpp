#include "vehicles/bench/bench_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::bench_motion_test {
namespace {

TEST(BenchMotion, HasTheRateOfASineWithoutDelay) {
  const double w = 2 * std::numbers::pi * 30;
  std::vector<double> x;
  for (int k = 0; k <= 500; ++k) x.push_back(1e-3 * std::sin(w * 0.002 * k));
  const BenchMotion motion = MotionThrough(x, 0.002);
  EXPECT_EQ(motion.samples(), 501);
  EXPECT_EQ(motion.steps, 2);
  EXPECT_DOUBLE_EQ(motion.step_s, 0.001);
  // At samples (w h)^4 / 180 = 1.1e-4 of the rate; ends apart.
  for (std::size_t k = 20; k < 480; ++k) {
    const double t = 0.002 * static_cast<double>(k);
    EXPECT_NEAR(motion.extension[2 * k], x[k], 1e-12);
    EXPECT_NEAR(motion.rate[2 * k], 1e-3 * w * std::cos(w * t), 1.2e-4 * 1e-3 * w);
    EXPECT_NEAR(motion.acceleration[2 * k], -1e-3 * w * w * std::sin(w * t), 0.0125 * 1e-3 * w * w);
  }
}

TEST(BenchMotion, StepsAreWholeFractionsOfASample) {
  EXPECT_EQ(MotionThrough(std::vector<double>(9), 1e-3).steps, 1);
  EXPECT_EQ(MotionThrough(std::vector<double>(9), 1e-4).steps, 1);
  const BenchMotion slow = MotionThrough(std::vector<double>(9), 0.01);
  EXPECT_EQ(slow.steps, 10);
  EXPECT_EQ(slow.extension.size(), 81);
}

}  // namespace
}  // namespace fourpost::bench_motion_test
