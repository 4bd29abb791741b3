#include "analysis/signals/median.h"

#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::median_test {
namespace {

TEST(Median, IsTheMiddleOne) {
  EXPECT_EQ(Median(std::vector<double>{7}), 7);
  EXPECT_EQ(Median(std::vector<double>{9, -1, 3}), 3);
  EXPECT_EQ(Median(std::array<double, 5>{5, 1, 4, 2, 100}), 4);
}

TEST(Median, IsBetweenTheTwoMiddleOnes) {
  EXPECT_EQ(Median(std::vector<double>{4, 1}), 2.5);
  EXPECT_EQ(Median(std::array<double, 4>{100, 3, -50, 1}), 2);
}

TEST(Median, TakesWhatIsInfinite) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Median(std::vector<double>{kInfinite, 1, 2}), 2);
  EXPECT_EQ(Median(std::vector<double>{kInfinite, 1, 2, kInfinite}), kInfinite);
}

TEST(Median, LeavesTheCallersValuesInTheirOrder) {
  const std::vector<double> values = {3, 1, 2};
  EXPECT_EQ(Median(values), 2);
  EXPECT_EQ(values, (std::vector<double>{3, 1, 2}));
}

TEST(Median, RefusesNone) { EXPECT_THROW(Median(std::vector<double>{}), std::invalid_argument); }

}  // namespace
}  // namespace fourpost::median_test
