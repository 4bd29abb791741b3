#include "analysis/signals/turning_points.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

namespace fourpost::turning_points_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TurningPoints, AreMaximaAndMinimaInTurn) {
  EXPECT_THAT(TurningPoints(std::vector<double>{0, 1, 3, 2, -1, -2, 0, 4, 2}), ElementsAre(2, 5, 7));
}

TEST(TurningPoints, OfWhatOnlyRises) {
  EXPECT_THAT(TurningPoints(std::vector<double>{0, 1, 2, 3}), IsEmpty());
  EXPECT_THAT(TurningPoints(std::vector<double>(5, 1.0)), IsEmpty());
  EXPECT_THAT(TurningPoints({}), IsEmpty());
}

// A swept sine whose amplitude falls to a hundredth, with noise of a thousandth.
TEST(TurningPoints, LeaveNoiseOut) {
  std::vector<double> signal;
  for (int k = 0; k < 20000; ++k) {
    const double t = k / 20000.0;
    const double noise = 1e-3 * std::sin(12.9898 * k * k);
    signal.push_back(std::pow(0.01, t) * std::sin(2 * std::numbers::pi * (20 * t + 40 * t * t)) + noise);
  }
  // Sixty cycles.
  EXPECT_EQ(TurningPoints(signal).size(), 120);
}

}  // namespace
}  // namespace fourpost::turning_points_test
