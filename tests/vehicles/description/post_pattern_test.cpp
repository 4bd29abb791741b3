#include "vehicles/description/post_pattern.h"

#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/findings.h"

namespace fourpost::post_pattern_test {
namespace {

using testing::ElementsAre;

/// Posts called "0", "1", ... under tyres of the ground at these x and y.
Vehicle OnPosts(const std::vector<Eigen::Vector2d>& places) {
  Vehicle vehicle;
  vehicle.links = {{.name = "ground"}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    vehicle.tyres.push_back({.point = {.link = 0, .xyz = {places[i].x(), places[i].y(), 0.3}}});
    vehicle.posts.push_back({.name = std::to_string(i), .tyre = static_cast<int>(i)});
  }
  return vehicle;
}

/// Whether the posts of the vehicle cannot make the pattern, for this reason.
bool Refuses(const Vehicle& vehicle, std::string_view pattern, const Finding& kind,
             const std::vector<std::string>& words) {
  try {
    PostPattern(vehicle, pattern);
    return false;
  } catch (const PatternError& error) {
    return error.found().kind == &kind && error.found().words == words;
  }
}

TEST(PostPattern, OfFourPostsFollowsTheirCorners) {
  // Front left, front right, rear left, rear right.
  const Vehicle car = ShippedVehicle("landrover110_model3");
  EXPECT_THAT(PostPattern(car, "heave"), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(PostPattern(car, "pitch"), ElementsAre(1, 1, -1, -1));
  EXPECT_THAT(PostPattern(car, "roll"), ElementsAre(1, -1, 1, -1));
  EXPECT_THAT(PostPattern(car, "warp"), ElementsAre(1, -1, -1, 1));
}

TEST(PostPattern, DoesNotDependOnTheOrderOrOriginOfThePosts) {
  const Vehicle car = OnPosts({{-1, 6}, {2, 6}, {2, 4.6}, {-1, 4.5}});
  EXPECT_THAT(PostPattern(car, "pitch"), ElementsAre(-1, 1, 1, -1));
  EXPECT_THAT(PostPattern(car, "roll"), ElementsAre(1, 1, -1, -1));
  EXPECT_THAT(PostPattern(car, "warp"), ElementsAre(-1, 1, -1, 1));
}

TEST(PostPattern, OfAPlanarCarIsHeaveOrPitch) {
  const Vehicle car = ShippedVehicle("landrover110_linkage");
  EXPECT_THAT(PostPattern(car, "heave"), ElementsAre(1, 1));
  EXPECT_THAT(PostPattern(car, "pitch"), ElementsAre(1, -1));
  EXPECT_TRUE(Refuses(car, "roll", kPatternSides, {"roll", "left", "right"}));
  EXPECT_TRUE(Refuses(car, "warp", kPatternSides, {"warp", "left", "right"}));
}

TEST(PostPattern, OfOnePostIsHeave) {
  const Vehicle corner = ShippedVehicle("quarter_car");
  EXPECT_THAT(PostPattern(corner, "heave"), ElementsAre(1));
  EXPECT_TRUE(Refuses(corner, "pitch", kPatternSides, {"pitch", "front", "rear"}));
}

TEST(PostPattern, CountsPlacesInTheGround) {
  // A link that is turned round: what lies ahead in its axes lies behind.
  Vehicle car = OnPosts({{1, 0}, {-1, 0}});
  car.links.push_back({.name = "body"});
  Joint turned = {.parent = 0, .child = 1};
  turned.pose.linear() = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  car.joints = {turned};
  for (Tyre& tyre : car.tyres) tyre.point.link = 1;
  EXPECT_THAT(PostPattern(car, "pitch"), ElementsAre(-1, 1));
}

TEST(PostPattern, TakesTheMiddleBetweenTheOutermost) {
  // A car with two rear axles.
  const Vehicle car = OnPosts({{0, 1}, {0, -1}, {-4, 1}, {-4, -1}, {-5, 1}, {-5, -1}});
  EXPECT_THAT(PostPattern(car, "pitch"), ElementsAre(1, 1, -1, -1, -1, -1));
  EXPECT_THAT(PostPattern(car, "warp"), ElementsAre(1, -1, -1, 1, -1, 1));
}

TEST(PostPattern, RefusesAPostInTheMiddle) {
  EXPECT_TRUE(Refuses(OnPosts({{0, 0}, {-2, 0}, {-4, 0}}), "pitch", kPatternMiddle, {"pitch", "1", "front", "rear"}));
}

TEST(PostPattern, RefusesWarpWithoutFourCorners) {
  EXPECT_TRUE(Refuses(OnPosts({{1, 1}, {1, -1}, {-1, 1}}), "warp", kPatternCorner, {"warp", "rear", "right"}));
  // Both would move alike.
  EXPECT_TRUE(Refuses(OnPosts({{1, 1}, {-1, -1}}), "warp", kPatternCorner, {"warp", "front", "right"}));
}

TEST(PostPattern, RefusesANameThatItDoesNotKnow) {
  EXPECT_TRUE(Refuses(OnPosts({{0, 0}}), "heav", kPatternUnknown, {"heav", ", did you mean 'heave'?"}));
  EXPECT_TRUE(Refuses(OnPosts({{0, 0}}), "bounc", kPatternUnknown, {"bounc", ", did you mean 'bounce'?"}));
}

}  // namespace
}  // namespace fourpost::post_pattern_test
