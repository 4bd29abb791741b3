#include "vehicles/multibody/loop_gaps.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <regex>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/lint_all.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/lint/findings.h"
#include "vehicles/multibody/findings.h"

namespace fourpost::loop_gaps_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kMillimetre = 1e-3;

Ball& BallOf(Vehicle& vehicle, const std::string& name) {
  for (Ball& ball : vehicle.balls)
    if (ball.name == name) return ball;
  throw std::invalid_argument(name);
}

/// The roadster with its lower arms' ball joints shifted outward.
Vehicle RoadsterWithLongerArms(double millimetres) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  BallOf(vehicle, "front_lower_left").parent.xyz.y() += millimetres * kMillimetre;
  BallOf(vehicle, "front_lower_right").parent.xyz.y() -= millimetres * kMillimetre;
  return vehicle;
}

int BallLine(Vehicle vehicle, const std::string& ball) { return BallOf(vehicle, ball).source_line; }

std::vector<std::string> Elements(const Vehicle& vehicle) {
  std::vector<std::string> elements;
  for (const OpenClosure& closure : OpenClosures(vehicle, kDrawnGap_m)) elements.push_back(closure.element);
  return elements;
}

TEST(OpenClosures, AreTwinsOnce) {
  EXPECT_THAT(Elements(ShippedVehicle("independent_roadster")), IsEmpty());
  const std::vector<OpenClosure> open = OpenClosures(RoadsterWithLongerArms(2), kDrawnGap_m);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].element, "fp:ball 'front_lower_left' (and of 'front_lower_right')");
  EXPECT_NEAR(open[0].gap, 2 * kMillimetre, 1e-12);  // rounding
}

TEST(OpenClosures, AreNotJoinedWhereTheirGapsDiffer) {
  Vehicle vehicle = RoadsterWithLongerArms(2);
  BallOf(vehicle, "front_lower_right").parent.xyz.y() -= kMillimetre;
  EXPECT_THAT(Elements(vehicle), ElementsAre("fp:ball 'front_lower_left'", "fp:ball 'front_lower_right'"));
}

TEST(OpenClosures, AreWeldsAndHingesToo) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.welds.push_back({.name = "w", .parent = {0, {0, 0, 0.301}}, .child = {1, {0, 0, 0}}, .source_line = 1});
  vehicle.hinges.push_back({.name = "h", .parent = {0, {0, 0.002, 0.3}}, .child = {1, {0, 0, 0}}, .source_line = 2});
  vehicle.balls.push_back({.name = "b", .parent = {0, {0, 0.00005, 0.3}}, .child = {1, {0, 0, 0}}, .source_line = 3});
  EXPECT_THAT(Elements(vehicle), ElementsAre("fp:weld 'w'", "fp:hinge 'h'"));
}

TEST(LoopGaps, WarnOfPointsThatAreApartAsWritten) {
  const Vehicle vehicle = RoadsterWithLongerArms(2);
  EXPECT_THAT(Lint(vehicle), ReportsOnly(kClosureOpen, BallLine(vehicle, "front_lower_left"),
                                         {"fp:ball 'front_lower_left' (and of 'front_lower_right')", "2 mm",
                                          "link 'front_upright_left' by 1.67 mm"}));
  EXPECT_EQ(Lint(RoadsterWithLongerArms(0.09)).Format(), "");
}

TEST(LoopGaps, AreThoseAsWrittenWhereTheLoopsCannotBeClosed) {
  const Vehicle vehicle = RoadsterWithLongerArms(200);
  const Diagnostics fault = Fault(vehicle);
  ASSERT_THAT(fault, ReportsOnly(kLoopOpen, BallLine(vehicle, "front_lower_left"),
                                 {"fp:ball 'front_lower_left' (and of 'front_lower_right')", "200 mm"}));
  // The other ball joint and the rod take their shares; all of it would be left without moving, more by divergence.
  std::smatch rest;
  ASSERT_TRUE(std::regex_search(fault.items()[0].message, rest, std::regex("200 mm.* ([0-9.]+) mm")));
  const double left = std::stod(rest[1]);
  EXPECT_GT(left, 10);
  EXPECT_LT(left, 100);
}

// One loop is wide open, and another one that can be closed is open by more than a drawing shows.
TEST(LoopGaps, DoNotBlameALoopThatCloses) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.balls.push_back({.name = "far", .parent = {0, {0.5, 0, 0.3}}, .child = {1, {0, 0, 0}}, .source_line = 1});
  vehicle.balls.push_back({.name = "near", .parent = {0, {0, 0, 0.71}}, .child = {2, {0, 0, 0}}, .source_line = 2});
  const Diagnostics faults =
      LoopGapFaults(vehicle, [](const Point&, const Point& child) { return child.link == 1 ? 0.3 : 0; });
  EXPECT_THAT(faults, ReportsOnly(kLoopOpen, 1, {"300 mm"}));
}

TEST(LoopGaps, AreNotEmpty) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.balls.push_back({.name = "b", .parent = {0, {0, 0, 0.3 + 1e-8}}, .child = {1, {0, 0, 0}}, .source_line = 1});
  EXPECT_TRUE(LoopGapFaults(vehicle, [](const Point&, const Point&) { return 0.0; }).HasErrors());
}

}  // namespace
}  // namespace fourpost::loop_gaps_test
