#include "vehicles/lint/ride_lint.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

std::string Told(const Vehicle& vehicle) {
  return LintRide(vehicle, Summarise(vehicle, vehicle.ParameterValues())).Format();
}

TEST(RideLint, FindsNothingInTheShippedVehicles) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf")) {
    if (entry.path().extension() != ".urdf") continue;
    EXPECT_EQ(Told(ShippedVehicle(entry.path().stem())), "") << entry.path().stem();
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
  const std::string told = Told(RoadsterWithTrackRodAt(2.23));
  EXPECT_THAT(told, HasSubstr("the wheel rate at fp:tyre 'front_left' is"));
  EXPECT_THAT(told, HasSubstr("check the points of its links, rods and springs"));
}

// A damper guided across its line, as by a wrong axis.
TEST(RideLint, TellsADamperThatDoesNotFollowItsWheel) {
  Vehicle vehicle = ShippedVehicle("landrover110_model3");
  vehicle.dampers[0].line.axis = Eigen::Vector3d(1, 0, 0.05).normalized();
  EXPECT_THAT(Told(vehicle), HasSubstr("has a motion ratio of"));
}

TEST(RideLint, NamesTheMotionThatGrows) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  for (Parameter& parameter : vehicle.parameters)
    if (parameter.name == "k") parameter.value = -1000;
  EXPECT_THAT(Told(vehicle), HasSubstr("unstable in its design pose: 'heave' grows by exp("));
}

}  // namespace
}  // namespace fourpost
