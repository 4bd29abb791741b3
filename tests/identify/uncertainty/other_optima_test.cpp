#include "identify/uncertainty/other_optima.h"

#include <gtest/gtest.h>

namespace fourpost::other_optima_test {
namespace {

/// Two shares of ranges from 0 to 10, known to 0.1 of the range by noise.
ParameterSpread Best() {
  ParameterSpread best{.lattice = Lattice({{"a", -10, 10, 0.1}, {"b", -10, 10, 0.1}})};
  best.values = Eigen::Vector2d(0, 0);
  best.judged = {0, 1};
  best.noise = best.total = 0.01 * Eigen::Matrix2d::Identity();
  return best;
}

EndedStart End(double cost, double a, double b) { return {cost, Eigen::Vector2d(a, b)}; }

TEST(OtherOptima, AreElsewhereAndNotMuchWorse) {
  const std::vector<EndedStart> ends = {End(105, 1, 1), End(105, 6, 0), End(106, 6.1, 0), End(200, -6, 0)};
  const auto others = OtherOptima(ends, Best(), 100, 1, Best().noise);
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0].values[0], 6);
}

// Noise twice as large as stated: costs count a quarter. A covariance four times as large does the same.
TEST(OtherOptima, CountCostsByTheNoiseThatIsThere) {
  const std::vector<EndedStart> ends = {End(200, -6, 0)};
  EXPECT_EQ(OtherOptima(ends, Best(), 100, 1, Best().noise).size(), 0u);
  EXPECT_EQ(OtherOptima(ends, Best(), 100, 2, Best().noise).size(), 1u);
  EXPECT_EQ(OtherOptima(ends, Best(), 100, 1, 4 * Best().noise).size(), 1u);
}

}  // namespace
}  // namespace fourpost::other_optima_test
