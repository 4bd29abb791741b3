#include "analysis/numerics/increasing_root.h"

#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::increasing_root_test {
namespace {

std::pair<double, double> ArcTangent(double x) { return {std::atan(x), 1 / (1 + x * x)}; }

TEST(IncreasingRoot, SolvesACubic) {
  const auto cubic = [](double x) { return std::pair(x * x * x + x, 3 * x * x + 1); };
  EXPECT_NEAR(IncreasingRoot(cubic, 10, 0, 10, 10), 2, 8 * kUlp);
}

// Newton's method alone diverges from beyond 1.39.
TEST(IncreasingRoot, HalvesTheBracketWhereNewtonWouldLeaveIt) {
  EXPECT_NEAR(IncreasingRoot(ArcTangent, 0.5, -1000, 1000, 900), std::tan(0.5), 8 * kUlp);
}

// Newton's method swings from one side to the other for ever.
TEST(IncreasingRoot, HalvesTheBracketWhereNewtonGainsNothing) {
  const auto root = [](double x) {
    const double size = std::sqrt(std::abs(x - 0.3));
    return std::pair(std::copysign(size, x - 0.3), 0.5 / size);
  };
  EXPECT_NEAR(IncreasingRoot(root, 0, -1, 1, 0.9), 0.3, 8 * kUlp);
}

TEST(IncreasingRoot, StopsAtAStepThatIsCloseEnough) {
  int evaluations = 0;
  const auto parabola = [&](double x) { return ++evaluations, std::pair(x * x, 2 * x); };
  // Newton's method for the root of 2 leaves half the square of its last step, over the root.
  EXPECT_NEAR(IncreasingRoot(parabola, 2, 0, 2, 2, 0.1), std::sqrt(2.0), 0.01 / (2 * std::sqrt(2.0)));
  EXPECT_LE(evaluations, 2);
}

TEST(IncreasingRoot, IsNanForNan) {
  EXPECT_TRUE(std::isnan(IncreasingRoot(ArcTangent, kNan, -1, 1, 0)));
  EXPECT_TRUE(std::isnan(IncreasingRoot(ArcTangent, 0.5, kNan, kNan, kNan)));
}

TEST(IncreasingRoot, StopsAtAStepThatPassesTheTarget) {
  int evaluations = 0;
  const auto step = [&](double x) { return ++evaluations, std::pair(x > 0.3 ? 1.0 : -1.0, 0.0); };
  EXPECT_NEAR(IncreasingRoot(step, 0, -1, 1, 0.9), 0.3, 8 * kUlp);
  EXPECT_LE(evaluations, 100);
}

}  // namespace
}  // namespace fourpost::increasing_root_test
