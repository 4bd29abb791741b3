#include "analysis/text/short_number.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fourpost::short_number_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(ShortNumber, HasSoManyDigits) {
  EXPECT_EQ(ShortNumber(0.012345), "0.0123");
  EXPECT_EQ(ShortNumber(-0.012345, 2), "-0.012");
  EXPECT_EQ(ShortNumber(1234.5), "1230");
  EXPECT_EQ(ShortNumber(4e-6), "4e-6");
  EXPECT_EQ(ShortNumber(0.9996), "1");
  EXPECT_EQ(ShortNumber(2.0), "2");
  EXPECT_EQ(ShortNumber(0), "0");
  EXPECT_EQ(ShortNumber(std::nan("")), "unknown");
  EXPECT_EQ(ShortNumber(kInfinite), "unknown");
}

TEST(ShortNumber, AtDigitsIsTheNearestSuchNumber) {
  EXPECT_EQ(AtDigits(1 / 3.0, 7), 0.3333333);
  EXPECT_EQ(AtDigits(2e5 / 3, 3), 66700);
  EXPECT_EQ(AtDigits(-5e-324, 17), -5e-324);
  EXPECT_EQ(AtDigits(0, 3), 0);
  EXPECT_EQ(AtDigits(-kInfinite, 3), -kInfinite);
  EXPECT_TRUE(std::isnan(AtDigits(std::nan(""), 3)));
  EXPECT_THROW(AtDigits(1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::short_number_test
