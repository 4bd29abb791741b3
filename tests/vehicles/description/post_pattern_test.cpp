#include "vehicles/description/post_pattern.h"

#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

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

auto Refuses(const Vehicle& vehicle, std::string_view pattern, const std::string& message) {
  return testing::Matches(ThrowsMessage<std::invalid_argument>(StrEq(message)))(
      [&vehicle, pattern] { PostPattern(vehicle, pattern); });
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
  EXPECT_TRUE(Refuses(car, "roll", "the posts cannot make 'roll': it takes posts both left and right"));
  EXPECT_TRUE(Refuses(car, "warp", "the posts cannot make 'warp': it takes posts both left and right"));
}

TEST(PostPattern, OfOnePostIsHeave) {
  const Vehicle corner = ShippedVehicle("quarter_car");
  EXPECT_THAT(PostPattern(corner, "heave"), ElementsAre(1));
  EXPECT_TRUE(Refuses(corner, "pitch", "the posts cannot make 'pitch': it takes posts both front and rear"));
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
  EXPECT_TRUE(Refuses(OnPosts({{0, 0}, {-2, 0}, {-4, 0}}), "pitch",
                      "the posts cannot make 'pitch': post '1' stands in the middle, neither front nor rear"));
}

TEST(PostPattern, RefusesWarpWithoutFourCorners) {
  EXPECT_TRUE(Refuses(OnPosts({{1, 1}, {1, -1}, {-1, 1}}), "warp",
                      "the posts cannot make 'warp': it takes a post at each corner, and none stands rear right"));
  // Both would move alike.
  EXPECT_TRUE(Refuses(OnPosts({{1, 1}, {-1, -1}}), "warp",
                      "the posts cannot make 'warp': it takes a post at each corner, and none stands front right"));
}

TEST(PostPattern, RefusesANameThatItDoesNotKnow) {
  EXPECT_TRUE(Refuses(OnPosts({{0, 0}}), "heav", "no pattern of posts is called 'heav', did you mean 'heave'?"));
}

}  // namespace
}  // namespace fourpost
