#include "analysis/signals/uniform_spline.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::uniform_spline_test {
namespace {

double Cubic(double t) { return 1 + t * (-2 + t * (0.5 + 3 * t)); }
double CubicSlope(double t) { return -2 + t * (1 + 9 * t); }
double CubicCurvature(double t) { return 1 + 18 * t; }

std::vector<double> Samples(double start, double step, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(Cubic(start + k * step));
  return values;
}

// A spline with the right slopes at its ends is the cubic that it samples.
TEST(UniformSpline, IsACubicThatItSamples) {
  const double last = -0.5 + 9 * 0.25;
  const UniformSpline spline(-0.5, 0.25, Samples(-0.5, 0.25, 10), CubicSlope(-0.5), CubicSlope(last));
  EXPECT_EQ(spline.end(), last);
  for (double t = -0.5; t <= last; t += 0.03) {
    // Rounding.
    EXPECT_NEAR(spline.At(t).value, Cubic(t), 1e-12);
    EXPECT_NEAR(spline.At(t).slope, CubicSlope(t), 1e-11);
    EXPECT_NEAR(spline.At(t).curvature, CubicCurvature(t), 1e-10);
  }
}

TEST(UniformSpline, RestsBeforeAndAfter) {
  const UniformSpline spline(1, 0.5, {2, 3, 5});
  EXPECT_EQ(spline.At(0.9).value, 2);
  EXPECT_EQ(spline.At(0.9).slope, 0);
  EXPECT_EQ(spline.At(2.1).value, 5);
  EXPECT_EQ(spline.At(2.1).curvature, 0);
  EXPECT_EQ(spline.At(1.5).value, 3);
  EXPECT_EQ(spline.At(2).value, 5);
  EXPECT_EQ(spline.At(2).slope, 0);
}

TEST(UniformSpline, HasNoStepInItsCurvature) {
  const UniformSpline spline(0, 1, {0, 1, 0, 2, -1});
  for (const double knot : {1.0, 2.0, 3.0}) {
    EXPECT_NEAR(spline.At(knot - 1e-9).curvature, spline.At(knot + 1e-9).curvature, 1e-7);
    EXPECT_NEAR(spline.At(knot - 1e-9).slope, spline.At(knot + 1e-9).slope, 1e-7);
  }
}

TEST(UniformSpline, RefusesWhatIsNoSignal) {
  EXPECT_THROW(UniformSpline(0, 0, {1, 2}), std::invalid_argument);
  EXPECT_THROW(UniformSpline(0, 1, {1}), std::invalid_argument);
  EXPECT_THROW(UniformSpline(0, 1, {1, NAN}), std::invalid_argument);
}

TEST(SlopeAtStart, IsThatOfACubicAndOfALine) {
  EXPECT_NEAR(SlopeAtStart(Samples(0.3, 0.1, 6), 0.1), CubicSlope(0.3), 1e-12);
  EXPECT_EQ(SlopeAtStart({1, 3}, 0.5), 4);
}

}  // namespace
}  // namespace fourpost::uniform_spline_test
