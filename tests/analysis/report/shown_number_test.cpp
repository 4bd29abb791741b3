#include "analysis/report/shown_number.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::shown_number_test {
namespace {

TEST(ShownNumber, HasSignificantDigits) {
  EXPECT_EQ(ShownNumber(0.12345, 2), "0.12");
  EXPECT_EQ(ShownNumber(12534.06, 6), "12\u2009534.1");
  EXPECT_EQ(ShownNumber(-1500, 2), "\u22121500");
  EXPECT_EQ(ShownNumber(0, 3), "0");
  EXPECT_EQ(ShownNumber(1.5e-9, 2), "1.5\u00b710\u207b\u2079");
  EXPECT_EQ(ShownNumber(-2.54e12, 2), "\u22122.5\u00b710\u00b9\u00b2");
  EXPECT_EQ(ShownNumber(9.99e-8, 2), "1.0\u00b710\u207b\u2077");
  EXPECT_EQ(ShownShort(2e9, 3), "2.00\u00b710\u2079");
  EXPECT_EQ(ShownNumber(NAN, 3), "\u2013");
  EXPECT_EQ(ShownNumber(-HUGE_VAL, 3), "\u2212\u221e");
}

TEST(ShownNumber, IsShortForRoundNumbers) {
  EXPECT_EQ(ShownShort(0.5, 3), "0.5");
  EXPECT_EQ(ShownShort(140, 4), "140");
  EXPECT_EQ(ShownShort(12, 3), "12");
  EXPECT_EQ(ShownShort(1.25, 4), "1.25");
}

TEST(ShownNumber, PartsThousandsFromFiveDigitsOn) {
  EXPECT_EQ(ShownDecimals(9977, 0), "9977");
  EXPECT_EQ(ShownDecimals(10063, 0), "10\u2009063");
  EXPECT_EQ(ShownDecimals(-1234567.25, 1), "\u22121\u2009234\u2009567.2");
  EXPECT_EQ(ShownDecimals(-0.0, 1), "0.0");
}

TEST(ShownNumber, DecimalsFollowTheDeviation) {
  EXPECT_EQ(DecimalsFor(1803.27, 9.55), 1);
  EXPECT_EQ(DecimalsFor(61.33, 0.7163), 2);
  EXPECT_EQ(DecimalsFor(4101, 73), 0);
  EXPECT_EQ(DecimalsFor(61.33, HUGE_VAL), 2);
  EXPECT_EQ(DecimalsFor(0, NAN), 0);
}

TEST(ShownNumber, UnitsHaveDotsAndRaisedPowers) {
  EXPECT_EQ(ShownUnit("kg*m^2"), "kg\u00b7m\u00b2");
  EXPECT_EQ(ShownUnit("N*s/m"), "N\u00b7s/m");
  EXPECT_EQ(ShownUnit("s^-2*m"), "s\u207b\u00b2\u00b7m");
}

}  // namespace
}  // namespace fourpost::shown_number_test
