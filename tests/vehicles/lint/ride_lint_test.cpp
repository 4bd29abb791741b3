#include "vehicles/lint/ride_lint.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/lint/findings.h"

namespace fourpost::ride_lint_test {
namespace {

using testing::AnyOf;

Diagnostics RideFindings(const Vehicle& vehicle) {
  return LintRide(vehicle, Summarise(vehicle, vehicle.ParameterValues()));
}

TEST(RideLint, FindsNothingInTheShippedVehicles) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf")) {
    if (entry.path().extension() != ".urdf") continue;
    EXPECT_EQ(RideFindings(ShippedVehicle(entry.path().stem())).Format(), "") << entry.path().stem();
  }
}

/// The roadster with its track rods' inner ends at this height [m].
Vehicle RoadsterWithTrackRodAt(double z) {
  Vehicle vehicle = ShippedVehicle("independent_roadster");
  for (Rod& rod : vehicle.rods)
    if (rod.name.starts_with("track_rod")) rod.parent.xyz.z() = z;
  return vehicle;
}

// 2.23 in place of 0.223 m.
TEST(RideLint, TellsAWheelRateThatNoSuspensionHas) {
  EXPECT_THAT(RideFindings(RoadsterWithTrackRodAt(2.23)),
              AnyOf(Reports(kWheelRateNegative, {"'front_left'"}), Reports(kWheelRateHigh, {"'front_left'"})));
}

// A damper guided across its line, as by a wrong axis.
TEST(RideLint, TellsADamperThatDoesNotFollowItsWheel) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  vehicle.dampers[0].line.axis = Eigen::Vector3d(1, 0, 0.05).normalized();
  EXPECT_THAT(RideFindings(vehicle), Reports(kMotionRatio));
}

TEST(RideLint, NamesTheMotionThatGrows) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  for (Parameter& parameter : vehicle.parameters)
    if (parameter.name == "k") parameter.value = -1000;
  EXPECT_THAT(RideFindings(vehicle), Reports(kVehicleUnstable, {"'heave' grows by exp("}));
}

}  // namespace
}  // namespace fourpost::ride_lint_test
