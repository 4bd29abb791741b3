#include "vehicles/lint/place_lint.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::place_lint_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The body's mesh and its coil's end reach up to 0.2 m.
TEST(VehicleLint, TellsOfASensorOffItsBody) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.sensors[0].point.xyz = {0, 0, 0.75};
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre(IsFinding(kSensorOffBody, {"fp:sensor 'a_sprung'", "link 'sprung'", "550 mm"})));
  vehicle.sensors[0].point.xyz = {0, 0, 0.65};
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsOfASensorOfOneAxleBesideTheOther) {
  Vehicle vehicle = ShippedVehicle("landrover110");
  const auto sensor = std::find_if(vehicle.sensors.begin(), vehicle.sensors.end(),
                                   [](const Sensor& one) { return one.name == "a_axle_FL"; });
  ASSERT_NE(sensor, vehicle.sensors.end());
  sensor->point.xyz.x() -= 2.794;
  EXPECT_THAT(Findings(vehicle, sensor->source_line), ElementsAre(IsFinding(kSensorOffBody)));
}

TEST(VehicleLint, TellsOfASensorThatReadsNothing) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.sensors[0].point.link = 0;
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line),
              ElementsAre(IsFinding(kSensorBlind, {"fp:sensor 'a_sprung'"})));
  vehicle.sensors[0].point.link = 2;
  vehicle.sensors[0].axis = Eigen::Vector3d::UnitY();
  EXPECT_THAT(Findings(vehicle, vehicle.sensors[0].source_line), ElementsAre(IsFinding(kSensorBlind)));
}

TEST(VehicleLint, TellsOfAnInertiaThatNoBodyOfThisSizeHas) {
  Vehicle vehicle = ShippedQuarterCar();
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 22;  // 1 m about
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  for (const std::size_t i : {1, 2}) vehicle.links[1].inertia[i].value = 550;
  EXPECT_THAT(Findings(vehicle, vehicle.links[1].line),
              ElementsAre(IsFinding(kInertiaUnusual, {"link 'unsprung'", "550 kg*m^2", "22 kg", "5 m"})));
}

TEST(VehicleLint, TellsOfATyreAboveItsPlatform) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.tyres[0].radius = 0.3;
  vehicle.tyres[0].point.xyz.z() = 0.015;
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
  vehicle.tyres[0].point.xyz.z() = -0.05;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line),
              ElementsAre(IsFinding(kTyreRadiusOff, {"fp:tyre 'tyre'", "250 mm", "0", "300 mm"})));
}

TEST(VehicleLint, TellsOfATyreBelowItsPlatform) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.tyres[0].point.xyz.z() = -0.6;
  EXPECT_THAT(Findings(vehicle, vehicle.tyres[0].source_line), ElementsAre(IsFinding(kTyreHeight, {"-300 mm"})));
}

TEST(VehicleLint, TellsOfLengths) {
  Vehicle vehicle = ShippedVehicle("single_wheel_station");
  vehicle.dampers[0].line.parent.xyz.z() = -0.39;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kLineShort, {"fp:damper 'damper'", "10 mm"})));
  vehicle.dampers[0].line.parent.xyz.z() = 2.7;
  EXPECT_THAT(Findings(vehicle, vehicle.dampers[0].source_line),
              ElementsAre(IsFinding(kLineLong, {"fp:damper 'damper'", "3.1 m"})));
  vehicle.dampers[0].line.axis = Eigen::Vector3d::UnitZ();
  EXPECT_THAT(Findings(vehicle, 0), IsEmpty());
}

TEST(VehicleLint, TellsThatThereIsNoPost) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.posts.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(IsFinding(kPostsNone)));
}

TEST_F(VehicleLintTest, TellsOfATyreWithoutAPost) {
  const std::string text = Replaced(kAxle, R"(<fp:post name="right" under="tyre_right"/>)", "");
  Look(text);
  ExpectWarning(text, "<fp:tyre name=\"tyre_right\"", kPostMissing, {"fp:tyre 'tyre_right'"});
}

TEST(VehicleLint, TellsThatThereIsNoSensor) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.sensors.clear();
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(IsFinding(kSensorsNone)));
}

}  // namespace
}  // namespace fourpost::place_lint_test
