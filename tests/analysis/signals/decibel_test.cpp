#include "analysis/signals/decibel.h"

#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::decibel_test {
namespace {

TEST(Decibel, TwentyAreAFactorOfTen) {
  EXPECT_DOUBLE_EQ(GainFromDecibel(20), 10);
  EXPECT_DOUBLE_EQ(DecibelFromGain(0.1), -20);
}

TEST(Decibel, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(DegreesFromRadians(std::numbers::pi), 180);
  EXPECT_DOUBLE_EQ(RadiansFromDegrees(-90), -std::numbers::pi / 2);
}

}  // namespace
}  // namespace fourpost::decibel_test
