#include "vehicles/lint/place_lint.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// The body's mesh and its coil's end reach up to 0.2 m.
TEST(VehicleLint, TellsOfASensorOffItsBody) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors[0].point.xyz = {0, 0, 0.75};
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre("fp:sensor 'a_sprung' is 550 mm off all that the file tells of link 'sprung', which carries "
                          "it: correct the link, or xyz, which is in metres and in the axes of its link"));
  vehicle.sensors[0].point.xyz = {0, 0, 0.65};
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsOfASensorOfOneAxleBesideTheOther) {
  Vehicle vehicle = ShippedVehicle("landrover110");
  const auto sensor = std::find_if(vehicle.sensors.begin(), vehicle.sensors.end(),
                                   [](const Sensor& one) { return one.name == "a_axle_FL"; });
  ASSERT_NE(sensor, vehicle.sensors.end());
  sensor->point.xyz.x() -= 2.794;
  EXPECT_THAT(Findings(vehicle, sensor->source_line), ElementsAre(HasSubstr("off all that the file tells of link")));
}

TEST(VehicleLint, TellsOfASensorThatReadsNothing) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors[0].point.link = 0;
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre(HasSubstr("fp:sensor 'a_sprung' reads nothing, however the vehicle moves")));
  vehicle.sensors[0].point.link = 2;
  vehicle.sensors[0].axis = Eigen::Vector3d::UnitY();
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line), ElementsAre(HasSubstr("reads nothing")));
}

TEST(VehicleLint, TellsOfAnInertiaThatNoBodyOfThisSizeHas) {
  Vehicle vehicle = QuarterCar();
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 22;  // 1 m about
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 550;
  EXPECT_THAT(Findings(vehicle, vehicle.links[1].line),
              ElementsAre(HasSubstr("inertia of link 'unsprung' is 550 kg*m^2 at a mass of 22 kg, a radius of gyration "
                                    "of 5 m, beyond all")));
}

TEST(VehicleLint, TellsOfATyreAboveItsPlatform) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].radius = 0.3;
  vehicle.tyres[0].point.xyz.z() = 0.015;
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  vehicle.tyres[0].point.xyz.z() = -0.05;
  EXPECT_THAT(
      Findings(vehicle, vehicle.tyres[0].source_line),
      ElementsAre("the point of fp:tyre 'tyre' is 250 mm above the platform, z = 0, in the design pose, but its "
                  "radius is 300 mm: correct the joint's origin, the point or the radius"));
}

TEST(VehicleLint, TellsOfATyreBelowItsPlatform) {
  Vehicle vehicle = QuarterCar();
  vehicle.tyres[0].point.xyz.z() = -0.6;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line), ElementsAre(HasSubstr("is -300 mm above the platform")));
}

TEST(VehicleLint, TellsOfLengths) {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  vehicle.dampers[0].line.parent.xyz.z() = -0.39;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(HasSubstr("fp:damper 'damper' is 10 mm long in the design pose: its direction turns")));
  vehicle.dampers[0].line.parent.xyz.z() = 2.7;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre("fp:damper 'damper' is 3.1 m long in the design pose: correct its ends"));
  vehicle.dampers[0].line.axis = Eigen::Vector3d::UnitZ();
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsThatThereIsNoPost) {
  Vehicle vehicle = QuarterCar();
  vehicle.posts.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(HasSubstr("the vehicle has tyres but no post")));
}

TEST_F(VehicleLintTest, TellsOfATyreWithoutAPost) {
  const std::string text = Replaced(kAxle, R"(<fp:post name="right" under="tyre_right"/>)", "");
  Look(text);
  ExpectWarning(text, "<fp:tyre name=\"tyre_right\"", "fp:tyre 'tyre_right' has no post while others have one");
}

TEST(VehicleLint, TellsThatThereIsNoSensor) {
  Vehicle vehicle = QuarterCar();
  vehicle.sensors.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(HasSubstr("the vehicle has no sensor")));
}

}  // namespace
}  // namespace fourpost
