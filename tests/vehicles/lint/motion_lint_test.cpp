#include "vehicles/lint/motion_lint.h"

#include <gmock/gmock.h>

#include "tests/vehicles/lint/odd_vehicle.h"
#include "vehicles/lint/bench_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::motion_lint_test {
namespace {

TEST_F(VehicleLintTest, TellsWhatNothingHoldsInThePlane) {
  const std::string text = Kart("damping=\"200 N*s/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"", kMotionFreeAlong, {"link 'body'"});
  ExpectWarning(text, "<link name=\"body\"", kMotionFreeAcross, {"lateral", "link 'body'"});
  ExpectWarning(text, "<link name=\"body\"", kMotionFreeAcross, {"yaw", "link 'body'"});
}

const std::string kPlaneDamping = "lateral_damping=\"500 N*s/m\" longitudinal_damping=\"100 N*s/m\" ";

TEST_F(VehicleLintTest, LetsDampedTyresHoldTheCar) {
  Look(Kart(kPlaneDamping + "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\""));
}

// By hand: w^2 = 4 x 20 kN/m / 200 kg fore and aft, hence 3.18 Hz. The body carries the tyres, so it is
// the chassis.
TEST_F(VehicleLintTest, TellsOfMotionInThePlaneThatNothingDamps) {
  const std::string text = Kart("damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"", kModeUndampedByTyres,
                {"'fore-aft'", "3.18 Hz", "0 %", "longitudinal_damping"});
  ExpectWarning(text, "<link name=\"body\"", kModeUndampedByTyres, {"'lateral'", "6.37 Hz", "0 %"});
  ExpectWarning(text, "<link name=\"body\"", kModeUndampedByTyres, {"'yaw'", "5.63 Hz"});
}

// By hand: c / (2 m w) = 4 c / (2 x 200 kg x 20/s) is 0.5 % at c = 10 N*s/m.
TEST_F(VehicleLintTest, TellsOfDampingBelowHalfAPerCent) {
  const auto kart = [](const std::string& along) {
    return Kart(
        "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\" lateral_damping=\"500 N*s/m\" "
        "longitudinal_damping=\"" +
        along + " N*s/m\"");
  };
  Look(kart("10.1"));
  Look(kart("9.9"));
  ExpectWarning(kart("9.9"), "<link name=\"body\"", kModeUndampedByTyres, {"'fore-aft'", "3.18 Hz", "0.495 %"});
}

TEST_F(VehicleLintTest, TellsOfRideThatNothingDamps) {
  const std::string text = Kart(kPlaneDamping + "lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  Look(text);
  ExpectWarning(text, "<link name=\"body\"", kModeUndamped, {"'heave'", "7.12 Hz", "0 %"});
  ExpectWarning(text, "<link name=\"body\"", kModeUndamped, {"'roll'", "9.19 Hz"});
  ExpectWarning(text, "<link name=\"body\"", kModeUndamped, {"'pitch'", "6.5 Hz", "0 %"});
}

// Fore-aft at sqrt(4 x 2 MN/m / 200 kg) = 31.8 Hz.
TEST_F(VehicleLintTest, LeavesModesAboveTheRigAlone) {
  Look(Kart("lateral_damping=\"5 kN*s/m\" damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"2 MN/m\""));
}

TEST_F(VehicleLintTest, TellsOnceWhatATwinHasAsWell) {
  const std::string bare = Kart(kPlaneDamping + "damping=\"200 N*s/m\" lateral=\"80 kN/m\" longitudinal=\"20 kN/m\"");
  const std::string mirrored = R"(<fp:mirror from="_left" to="_right"/>
<fp:frame name="end_left" link="body" xyz="0 0.4 0.3"/>
<fp:frame name="rig_left" link="ground" xyz="0 0.4 1"/>
<fp:spring name="tie_left" parent="rig_left" child="end_left"><linear stiffness="9 N/m" preload="0 N"/></fp:spring>
</robot>)";
  const std::string text = Replaced(bare, "</robot>", mirrored);
  Look(text);
  ExpectWarning(text, "<fp:spring name=\"tie_left\"", kNumberUnusual, {"stiffness", "fp:spring 'tie_left'", "9 N/m"});
}

Vehicle ShippedDamper() {
  Diagnostics diagnostics;
  return ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/damper/model2.urdf", diagnostics).value();
}

TEST(BenchVehicle, HasNothingToFind) { EXPECT_THAT(Findings(ShippedDamper(), 0), testing::IsEmpty()); }

TEST(BenchVehicle, IsNoCarWithoutSensors) {
  Vehicle car = ShippedQuarterCar();
  car.sensors.clear();
  EXPECT_THAT(Findings(car, 0), testing::Contains(IsFinding(kSensorsNone)));
  EXPECT_FALSE(IsBenchVehicle(car));
}

TEST(BenchVehicle, IsNoLinkWithoutDamper) {
  Vehicle vehicle = ShippedDamper();
  vehicle.dampers.clear();
  EXPECT_FALSE(IsBenchVehicle(vehicle));
}

}  // namespace
}  // namespace fourpost::motion_lint_test
