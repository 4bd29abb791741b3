#include "vehicles/lint/static_lint.h"

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::static_lint_test {
namespace {

using testing::ElementsAre;

// A weight 50 mm outside the left wheel lifts the body off the right coil, another one the wheel as well.
TEST_F(VehicleLintTest, TellsOfSpringsAndTyresThatArePulled) {
  const std::string tilting = Replaced(kAxle, R"(<origin xyz="0 0 0"/>)", R"(<origin xyz="0 0.75 0"/>)");
  Look(tilting);
  // 500 kg x 9.80665 m/s^2 x 50 mm / 1.4 m = 175 N.
  ExpectWarning(tilting, R"(<fp:spring name="coil_right")", kSpringPulled, {"fp:spring 'coil_right'", "175 N"});
  const std::string tilted = Replaced(kAxle, R"(<origin xyz="0 0 0"/>)", R"(<origin xyz="0 1 0"/>)");
  Look(tilted);
  ExpectWarning(tilted, R"(<fp:spring name="coil_right")", kSpringPulled, {"fp:spring 'coil_right'", "1.05 kN"});
  // Less the wheel's weight of 392 N.
  ExpectWarning(tilted, R"(<fp:tyre name="tyre_right")", kTyrePullsAtRest, {"fp:tyre 'tyre_right'", "658 N"});
}

TEST(VehicleLint, TellsOfAnAxisThatPointsTheWrongWay) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.springs[0].line.axis = -Eigen::Vector3d::UnitZ();
  EXPECT_THAT(Findings(vehicle, vehicle.springs[0].source_line), ElementsAre(IsFinding(kSpringPulled, {"axis"})));
}

TEST(VehicleLint, TellsWhatElseCarriesTheWeight) {
  Vehicle vehicle = ShippedQuarterCar();
  Spring prop = vehicle.springs[0];
  prop.name = "prop";
  prop.line.child = {0, {0, 0, 0}};
  vehicle.springs.push_back(prop);
  EXPECT_THAT(Findings(vehicle, 0), ElementsAre(IsFinding(kWeightElsewhere, {"fp:spring 'prop'"})));
}

// A trailing arm hinged on the ground, its tyre half way between hinge and coil.
TEST(VehicleLint, TellsOfAJointThatCarriesTheWeight) {
  Vehicle vehicle = ShippedQuarterCar();
  vehicle.joints[0].type = Joint::Type::kRevolute;
  vehicle.joints[0].axis = Eigen::Vector3d::UnitY();
  vehicle.joints[0].pose.translation().x() = -1;
  vehicle.links[1].com[0].value = 1;
  vehicle.springs[0].line.child.xyz.x() = 1;
  vehicle.dampers[0].line.child.xyz.x() = 1;
  vehicle.tyres[0].point.xyz.x() = 0.5;
  for (Sensor& sensor : vehicle.sensors) sensor.point.xyz.x() = 0.5;
  EXPECT_THAT(
      Findings(vehicle, 0),
      ElementsAre(IsFinding(kWeightElsewhere, {"joint 'wheel_travel'", "joint 'body_travel'", "4.35 kN", "2.18 kN"})));
}

}  // namespace
}  // namespace fourpost::static_lint_test
