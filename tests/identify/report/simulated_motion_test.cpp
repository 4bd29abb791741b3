#include "identify/report/simulated_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost::simulated_motion_test {
namespace {

PostMotion Sine(double frequency_Hz, double end_s) {
  const SweptSine sine{.first_Hz = frequency_Hz,
                       .last_Hz = frequency_Hz,
                       .duration_s = end_s,
                       .amplitude_m = 1e-4,
                       .top_speed = 10,
                       .top_acceleration = 1000};
  return FollowPattern(sine.Signal(), {1.0});
}

int Crossings(const Eigen::VectorXd& heights) {
  int crossings = 0;
  for (Eigen::Index k = 1; k < heights.size(); ++k) crossings += heights[k - 1] < 0 && heights[k] >= 0 ? 1 : 0;
  return crossings;
}

TEST(SimulatedMotion, ShowsTheHighestFrequencyAsItIs) {
  const Vehicle car = ShippedVehicle("quarter_car");
  const HistoryMotion motion = SimulatedMotion(car, Sine(40, 10), {0, 10}, 40);
  EXPECT_GE(motion.rate_Hz, 3 * 40);
  EXPECT_NEAR(Crossings(motion.posts.col(0)), 400, 2);
  EXPECT_EQ(motion.posts.rows(), motion.coordinates.rows());
}

TEST(SimulatedMotion, EndsEarlyInsteadOfBecomingCoarse) {
  const Vehicle car = ShippedVehicle("quarter_car");
  const HistoryMotion motion = SimulatedMotion(car, Sine(40, 1200), {0, 1200}, 40);
  EXPECT_GE(motion.rate_Hz, 3 * 40);
  const double shown_s = static_cast<double>(motion.posts.rows()) / motion.rate_Hz;
  EXPECT_GT(shown_s, 100);
  EXPECT_LT(shown_s, 1200);
}

// A post whose highest frequency nobody states.
TEST(SimulatedMotion, FindsTheHighestFrequencyOfTheMotion) {
  const Vehicle car = ShippedVehicle("quarter_car");
  EXPECT_GE(SimulatedMotion(car, Sine(40, 5), {0, 5}, 0).rate_Hz, 3 * 40);
  const HistoryMotion slow = SimulatedMotion(car, Sine(1, 10), {0, 10}, 0);
  EXPECT_EQ(slow.rate_Hz, 60);
  EXPECT_EQ(slow.posts.rows(), 601);
}

}  // namespace
}  // namespace fourpost::simulated_motion_test
