#include "vehicles/response/amplitude_law.h"

#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::amplitude_law_test {
namespace {

TEST(AmplitudeLaw, TheLeastLimitCounts) {
  const double w = 2 * std::numbers::pi;
  const AmplitudeLaw law{.displacement_m = 0.01, .velocity_mps = 0.01 * w, .acceleration_mps2 = 0.02 * w * w};
  EXPECT_EQ(law.At(0.5), 0.01);
  EXPECT_NEAR(law.At(1.5), 0.01 / 1.5, 1e-15);  // rounding
  EXPECT_NEAR(law.At(4), 0.02 / 16, 1e-15);
  EXPECT_EQ(AmplitudeLaw{.displacement_m = 1}.At(100), 1);
}

}  // namespace
}  // namespace fourpost::amplitude_law_test
