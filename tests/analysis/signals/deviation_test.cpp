#include "analysis/signals/deviation.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::deviation_test {
namespace {

TEST(Deviation, OfWholeNumbers) {
  const std::vector<double> signal = {1, 2, 3, 6};
  EXPECT_EQ(Mean(signal), 3);
  EXPECT_DOUBLE_EQ(DeviationOf(signal), std::sqrt(14.0 / 4));
}

// The square of the sum over the sum of squares would leave nothing of it.
TEST(Deviation, IsThatAboutALargeMean) {
  EXPECT_EQ(DeviationOf(std::vector<double>{1e9 - 1, 1e9 + 1, 1e9 - 1, 1e9 + 1}), 1);
}

TEST(Deviation, OfOneAndOfNone) {
  EXPECT_EQ(DeviationOf(std::vector<double>{4}), 0);
  EXPECT_EQ(DeviationOf({}), 0);
  EXPECT_TRUE(std::isnan(Mean({})));
}

}  // namespace
}  // namespace fourpost::deviation_test
