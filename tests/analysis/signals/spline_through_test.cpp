#include "analysis/signals/spline_through.h"

#include <vector>

#include <gtest/gtest.h>

namespace fourpost::spline_through_test {
namespace {

// Slopes at the ends are those of the cubic, too.
TEST(SplineThrough, IsTheCubicThatItSamples) {
  const auto cubic = [](double t) { return 2 - t + 3 * t * t - 0.5 * t * t * t; };
  std::vector<double> samples;
  for (int k = 0; k < 7; ++k) samples.push_back(cubic(1 + 0.5 * k));
  const UniformSpline spline = SplineThrough(samples, 1, 0.5);
  // Rounding.
  for (const double t : {1.0, 1.1, 2.25, 3.9, 4.0}) EXPECT_NEAR(spline.At(t).value, cubic(t), 1e-12) << t;
  EXPECT_NEAR(spline.At(4).slope, -1 + 6 * 4 - 1.5 * 16, 1e-11);
}

}  // namespace
}  // namespace fourpost::spline_through_test
