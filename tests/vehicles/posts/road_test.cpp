#include "vehicles/posts/road.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/vehicles/posts/consistent_motion.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::road_test {
namespace {

RandomRoad ClassB() { return {.roughness_m3 = RoadRoughness("B").value(), .speed = 20, .duration_s = 120, .seed = 3}; }

double RootMeanSquare(const std::function<double(double)>& signal, double start, double end) {
  double sum = 0;
  int count = 0;
  for (double t = start; t < end; t += 4e-3, ++count) sum += std::pow(signal(t), 2);
  return std::sqrt(sum / count);
}

TEST(Road, HasTheRoughnessOfItsClass) {
  EXPECT_EQ(RoadRoughness("A"), 16e-6);
  EXPECT_EQ(RoadRoughness("C"), 256e-6);
  EXPECT_FALSE(RoadRoughness("b"));
  EXPECT_FALSE(RoadRoughness("I"));
}

/// Post FL, FR, RL or RR at a time.
double Height(const PostMotion& motion, double t, std::size_t post) {
  std::array<PostState, 4> posts;
  motion(t, posts);
  return posts[post].height;
}

TEST(Road, HasVelocitiesOfIts8608Density) {
  const Vehicle car = ShippedVehicle("landrover110_model3");
  const PostMotion motion = ClassB().MotionOf(car);
  for (const std::size_t post : {0u, 1u}) {
    const double velocity = RootMeanSquare(
        [&](double t) {
          std::array<PostState, 4> posts;
          motion(t, posts);
          return posts[post].velocity;
        },
        2, 118);
    // (2 pi)^2 G n0^2 v over the band of 29.5 Hz, G n0^2 = 64e-6 x 0.01.
    const double expected = 2 * std::numbers::pi * std::sqrt(64e-6 * 0.01 * 20 * 29.5);
    EXPECT_NEAR(velocity / expected, 1, 0.03);
  }
}

TEST(Road, ComesToTheRearAWheelbaseLater) {
  const Vehicle car = ShippedVehicle("landrover110_model3");
  const PostMotion motion = ClassB().MotionOf(car);
  const double delay = 2.794 / 20;
  for (const double t : {3.0, 17.3, 60.0}) {
    EXPECT_NEAR(Height(motion, t + delay, 2), Height(motion, t, 0), 1e-9);
    EXPECT_NEAR(Height(motion, t + delay, 3), Height(motion, t, 1), 1e-9);
  }
  EXPECT_EQ(Height(motion, 0, 0), 0);
}

/// Root mean square of half the difference of the tracks over that of their mean.
double Apart(RandomRoad road) {
  const Vehicle car = ShippedVehicle("landrover110_model3");
  const PostMotion motion = road.MotionOf(car);
  const auto difference = [&](double t) { return 0.5 * (Height(motion, t, 0) - Height(motion, t, 1)); };
  const auto mean = [&](double t) { return 0.5 * (Height(motion, t, 0) + Height(motion, t, 1)); };
  return RootMeanSquare(difference, 2, 118) / RootMeanSquare(mean, 2, 118);
}

TEST(Road, HasLongWavesAlikeOnBothSidesAndShortOnesApart) {
  // x K1(x) with b = 1.486 m, at 40 m: x = 0.233, coherence 0.944; difference over mean sqrt(0.056 / 1.944) = 0.17.
  RandomRoad slow = ClassB();
  slow.lower_Hz = 0.48;
  slow.upper_Hz = 0.52;
  EXPECT_NEAR(Apart(slow), 0.17, 0.07);
  // At 1 m: x = 9.3, coherence 1e-3 of it.
  RandomRoad fast = ClassB();
  fast.lower_Hz = 19;
  fast.upper_Hz = 21;
  EXPECT_NEAR(Apart(fast), 1, 0.2);
}

TEST(Road, IsOneTrackForPostsInLine) {
  const Vehicle car = ShippedVehicle("landrover110_linkage");
  const PostMotion motion = ClassB().MotionOf(car);
  std::array<PostState, 2> front;
  std::array<PostState, 2> rear;
  motion(5, front);
  motion(5 + 2.794 / 20, rear);
  EXPECT_NEAR(front[0].height, rear[1].height, 1e-9);
  EXPECT_NE(front[0].height, 0);
}

TEST(Road, MovesConsistently) {
  const Vehicle car = ShippedVehicle("landrover110_model3");
  ExpectConsistent(ClassB().MotionOf(car), 4, 0, 120, 1 / (64.0 * 30));
}

TEST(Road, IsThatOfItsSeedAndRefusesWhatCannotBe) {
  const Vehicle car = ShippedVehicle("landrover110_model3");
  RandomRoad other = ClassB();
  other.seed = 4;
  EXPECT_EQ(Height(ClassB().MotionOf(car), 7, 1), Height(ClassB().MotionOf(car), 7, 1));
  EXPECT_NE(Height(ClassB().MotionOf(car), 7, 1), Height(other.MotionOf(car), 7, 1));
  other.speed = 0;
  EXPECT_THROW(other.MotionOf(car), std::invalid_argument);
  other = ClassB();
  other.upper_Hz = 0.4;
  EXPECT_THROW(other.MotionOf(car), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::road_test
