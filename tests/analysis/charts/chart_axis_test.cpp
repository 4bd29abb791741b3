#include "analysis/charts/chart_axis.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/rounding.h"

namespace fourpost::chart_axis_test {
namespace {

using testing::ElementsAre;

TEST(LinearAxis, HasTheSmallestStepOfOneTwoFiveThatSuffices) {
  EXPECT_THAT(LinearAxis(0, 4, 5).ticks, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(LinearAxis(0, 8, 5).ticks, ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(LinearAxis(0, 11, 5).ticks, ElementsAre(0, 5, 10, 15));
  EXPECT_THAT(LinearAxis(0, 110, 5).ticks, ElementsAre(0, 50, 100, 150));
}

TEST(LinearAxis, EndsOnTicks) {
  const ChartAxis axis = LinearAxis(-43, 8, 5);
  EXPECT_THAT(axis.ticks, ElementsAre(-60, -40, -20, 0, 20));
  EXPECT_EQ(axis.lower, -60);
  EXPECT_EQ(axis.upper, 20);
}

TEST(LinearAxis, HasTicksThatPrintShort) {
  EXPECT_THAT(LinearAxis(0.1, 0.5, 5).ticks, ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5));
  EXPECT_FALSE(std::signbit(LinearAxis(-0.2, 0.2, 5).ticks[2]));
}

TEST(LinearAxis, RefusesLimitsThatDoNotIncrease) {
  EXPECT_THROW(LinearAxis(1, 1, 5), std::invalid_argument);
  EXPECT_THROW(LinearAxis(kNan, 1, 5), std::invalid_argument);
  EXPECT_THROW(LinearAxis(0, kInfinity, 5), std::invalid_argument);
}

TEST(LinearAxis, RefusesASingleInterval) { EXPECT_THROW(LinearAxis(-1, 1, 1), std::invalid_argument); }

TEST(LogAxis, HasTheTicksOfAFrequencySweep) {
  EXPECT_THAT(LogAxis(0.47, 31.8).ticks, ElementsAre(0.5, 1, 2, 5, 10, 20, 30));
  EXPECT_THAT(LogAxis(0.3, 4).ticks, ElementsAre(0.3, 0.5, 1, 2, 4));
}

TEST(LogAxis, LeavesOutALastTickThatWouldTouchItsNeighbour) {
  EXPECT_THAT(LogAxis(1, 6).ticks, ElementsAre(1, 2, 5));
  EXPECT_THAT(LogAxis(0.4, 2).ticks, ElementsAre(0.5, 1, 2));
}

TEST(LogAxis, HasLinearTicksWithinPartOfADecade) { EXPECT_THAT(LogAxis(2.4, 4.1).ticks, ElementsAre(2.5, 3, 3.5, 4)); }

TEST(LogAxis, KeepsItsLimits) {
  EXPECT_EQ(LogAxis(0.47, 31.8).lower, 0.47);
  EXPECT_EQ(LogAxis(0.47, 31.8).upper, 31.8);
}

TEST(LogAxis, RefusesLimitsThatAreNotPositive) {
  EXPECT_THROW(LogAxis(0, 10), std::invalid_argument);
  EXPECT_THROW(LogAxis(-1, 10), std::invalid_argument);
}

TEST(ChartAxis, PlacesValuesBetweenItsLimits) {
  const ChartAxis linear{.lower = -10, .upper = 30};
  EXPECT_EQ(linear.Fraction(0), 0.25);
  const ChartAxis logarithmic{.lower = 1, .upper = 16, .logarithmic = true};
  EXPECT_DOUBLE_EQ(logarithmic.Fraction(8), 0.75);
  EXPECT_FALSE(std::isfinite(logarithmic.Fraction(0)));
  EXPECT_FALSE(std::isfinite(logarithmic.Fraction(-8)));
}

}  // namespace
}  // namespace fourpost::chart_axis_test
