#include "vehicles/laws/monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::monotone_curve_test {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

struct Points {
  std::vector<double> x;
  std::vector<double> y;
};

/// Strictly increasing; steps of x span a factor of 10, of y one of 1000.
Points RandomPoints(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> exponent(0, 1);
  Points points{{-1}, {-1}};
  for (int i = 0; i < 12; ++i) {
    points.x.push_back(points.x.back() + 0.1 * std::pow(10, exponent(engine)));
    points.y.push_back(points.y.back() + 1e-3 * std::pow(1000, exponent(engine)));
  }
  return points;
}

/// From half a unit before the first point to half a unit beyond the last.
std::vector<double> Grid(const Points& points, int count) {
  std::vector<double> grid;
  for (int i = 0; i < count; ++i)
    grid.push_back(points.x.front() - 0.5 + (points.x.back() - points.x.front() + 1) * i / (count - 1));
  return grid;
}

TEST(MonotoneCurve, PassesThroughItsPoints) {
  const MonotoneCurve curve({-1, 0, 0.5, 3}, {-7, 0, 1, 1.5});
  EXPECT_DOUBLE_EQ(curve.Value(-1), -7);
  EXPECT_EQ(curve.Value(0), 0);
  EXPECT_EQ(curve.Value(0.5), 1);
  EXPECT_EQ(curve.Value(3), 1.5);
}

TEST(MonotoneCurve, OfPointsOnALineIsTheLine) {
  const MonotoneCurve curve({-2, -1.5, 0, 4}, {-4, -3, 0, 8});
  for (double x = -5; x < 7; x += 0.37) {
    EXPECT_NEAR(curve.Value(x), 2 * x, 16 * kUlp * 10);
    EXPECT_NEAR(curve.Slope(x), 2, 16 * kUlp);
  }
}

// Chords 1 and 99, slopes 1, 50, 99 before the first piece reduces its own to the circle of radius 3.
TEST(MonotoneCurve, HasTheSlopesOfFritschAndCarlson) {
  const MonotoneCurve curve({0, 1, 2}, {0, 1, 100});
  const double radius = std::hypot(1, 50);
  EXPECT_NEAR(curve.Slope(0), 3 / radius, 8 * kUlp);
  EXPECT_NEAR(curve.Slope(1), 150 / radius, 32 * kUlp);
  EXPECT_NEAR(curve.Slope(2), 99, 1000 * kUlp);
}

TEST(MonotoneCurve, GoesStraightOnBeyondItsEnds) {
  const MonotoneCurve curve({0, 1, 2}, {0, 1, 100});
  EXPECT_NEAR(curve.Value(-2), -2 * curve.Slope(0), 8 * kUlp);
  EXPECT_NEAR(curve.Value(5), 100 + 3 * curve.Slope(2), 1000 * kUlp);
  EXPECT_EQ(curve.Slope(-2), curve.Slope(0));
}

// From zero, which lies beyond an end of the second curve. Simpson's rule is exact for cubics; its grid has the points.
TEST(MonotoneCurve, IntegralIsTheAreaBelowIt) {
  for (const MonotoneCurve& curve :
       {MonotoneCurve({-1, 0.5, 2}, {-3, 1, 100}), MonotoneCurve({0.5, 1.5, 2}, {-30, 1, 2})}) {
    double area = 0;
    for (int i = 0; i < 6; ++i) {
      const double x = 0.5 * i;
      area += (curve.Value(x) + 4 * curve.Value(x + 0.25) + curve.Value(x + 0.5)) / 12;
      EXPECT_NEAR(curve.Integral(x + 0.5), area, 400 * 16 * kUlp) << x;
    }
    area = 0;
    for (int i = 0; i > -4; --i) {
      const double x = 0.5 * i;
      area -= (curve.Value(x) + 4 * curve.Value(x - 0.25) + curve.Value(x - 0.5)) / 12;
      EXPECT_NEAR(curve.Integral(x - 0.5), area, 400 * 16 * kUlp) << x;
    }
  }
}

TEST(MonotoneCurve, StaysFlatBetweenEqualPoints) {
  const MonotoneCurve curve({0, 1, 2, 3}, {0, 5, 5, 6});
  for (double x = 1; x < 2; x += 0.1) EXPECT_EQ(curve.Value(x), 5);
  EXPECT_EQ(curve.LeastSlope(), 0);
}

TEST(MonotoneCurve, IncreasesBetweenRandomIncreasingPoints) {
  std::mt19937_64 engine(3);
  for (int k = 0; k < 200; ++k) {
    const Points points = RandomPoints(engine);
    const MonotoneCurve curve(points.x, points.y);
    EXPECT_GT(curve.LeastSlope(), 0);
    double last = -kInfinity;
    for (const double x : Grid(points, 1001)) {
      EXPECT_GT(curve.Value(x), last);
      last = curve.Value(x);
    }
  }
}

TEST(MonotoneCurve, SlopeIsTheDerivative) {
  std::mt19937_64 engine(4);
  const Points points = RandomPoints(engine);
  const MonotoneCurve curve(points.x, points.y);
  constexpr double kStep = 1e-6;
  // A piece's third derivative, up to 1e3, times h^2/6, and rounding of values of about 5 over the step.
  for (const double x : Grid(points, 777))
    EXPECT_NEAR(curve.Slope(x), (curve.Value(x + kStep) - curve.Value(x - kStep)) / (2 * kStep), 1e-8);
}

TEST(MonotoneCurve, SlopeBoundsAreReachedAndNeverPassed) {
  std::mt19937_64 engine(5);
  for (int k = 0; k < 50; ++k) {
    const Points points = RandomPoints(engine);
    const MonotoneCurve curve(points.x, points.y);
    double least = kInfinity;
    double greatest = 0;
    for (const double x : Grid(points, 20001)) {
      least = std::min(least, curve.Slope(x));
      greatest = std::max(greatest, curve.Slope(x));
    }
    const double rounding = 100 * kUlp * greatest;
    EXPECT_GE(least, curve.LeastSlope() - rounding);
    EXPECT_LE(greatest, curve.GreatestSlope() + rounding);
    // The slope's own change over the grid's step, of a thousandth of a piece.
    EXPECT_NEAR(least, curve.LeastSlope(), 0.01 * greatest);
    EXPECT_NEAR(greatest, curve.GreatestSlope(), 0.01 * greatest);
  }
}

TEST(MonotoneCurve, ArgumentIsTheInverse) {
  std::mt19937_64 engine(6);
  for (int k = 0; k < 50; ++k) {
    const Points points = RandomPoints(engine);
    const MonotoneCurve curve(points.x, points.y);
    // Rounding of values of about 5, seen through the slope.
    for (const double x : Grid(points, 501))
      EXPECT_NEAR(curve.Argument(curve.Value(x)), x, 16 * kUlp * (1 + 5 / curve.LeastSlope()));
    for (std::size_t i = 0; i < points.x.size(); ++i)
      EXPECT_NEAR(curve.Argument(points.y[i]), points.x[i], 16 * kUlp * (1 + 5 / curve.LeastSlope()));
  }
}

TEST(MonotoneCurve, IsNanForNan) {
  const MonotoneCurve curve({0, 1, 2}, {0, 1, 100});
  EXPECT_TRUE(std::isnan(curve.Value(kNan)));
  EXPECT_TRUE(std::isnan(curve.Slope(kNan)));
  EXPECT_TRUE(std::isnan(curve.Argument(kNan)));
}

void ExpectRefused(const std::vector<double>& x, const std::vector<double>& y, const std::string& message) {
  EXPECT_THAT([&] { MonotoneCurve(x, y, "speed", "force"); }, ThrowsMessage<std::invalid_argument>(StrEq(message)));
}

TEST(MonotoneCurve, RefusesPointsThatAreNoCurve) {
  ExpectRefused({1}, {1}, "speed: number of points = 1, must be at least 2");
  ExpectRefused({1, 2}, {1}, "force: number of points = 1, must be that of speed");
  ExpectRefused({1, kNan}, {1, 2}, "speed = nan, must be finite");
  ExpectRefused({1, 2}, {1, kNan}, "force = nan, must be finite");
  ExpectRefused({1, 2, 2}, {1, 2, 3}, "speed = 2, must be above the one before, 2");
  ExpectRefused({1, 2, 3}, {1, 2, 1.5}, "force = 1.5, must be not below the one before, 2");
}

}  // namespace
}  // namespace fourpost::monotone_curve_test
