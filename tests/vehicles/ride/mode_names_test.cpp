#include "vehicles/ride/mode_names.h"

#include <filesystem>
#include <limits>
#include <set>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::mode_names_test {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::vector<Mode> NamedModes(const Vehicle& vehicle) { return Summarise(vehicle, vehicle.ParameterValues()).modes; }

std::vector<std::string> Names(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (const Mode& mode : NamedModes(vehicle)) names.push_back(mode.name);
  return names;
}

TEST(ModeNames, OfTheQuarterCarAreHeaveAndWheelHop) {
  EXPECT_THAT(Names(ShippedVehicle("quarter_car")), ElementsAre("heave", "wheel hop"));
}

TEST(ModeNames, OfCarsInThePlaneAreHeavePitchAndHops) {
  for (const char* car : {"landrover110_linkage", "landrover110_model1"})
    EXPECT_THAT(Names(ShippedVehicle(car)), ElementsAre("heave", "pitch", "front hop", "rear hop"));
}

/// A frame on four tyres of its own, with a seat on a cushion.
constexpr const char* kKart = R"(<robot name="kart" xmlns:fp="urn:fourpost:vehicle:1">
<link name="ground"/>
<link name="frame">
  <inertial><mass value="200"/><inertia ixx="30" iyy="60" izz="80" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<link name="seat">
  <inertial><mass value="20"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="frame" type="floating"><parent link="ground"/><child link="frame"/><origin xyz="0 0 0.2"/></joint>
<joint name="cushion" type="prismatic">
  <parent link="frame"/><child link="seat"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/><limit effort="0" velocity="0"/>
</joint>
<fp:spring name="cushion" parent="frame" child="seat"><linear stiffness="20 kN/m"/></fp:spring>
<fp:tyre name="FL" link="frame" xyz="0.5 0.5 0" stiffness="100 kN/m" lateral="80 kN/m" longitudinal="20 kN/m"/>
<fp:tyre name="FR" link="frame" xyz="0.5 -0.5 0" stiffness="100 kN/m" lateral="80 kN/m" longitudinal="20 kN/m"/>
<fp:tyre name="RL" link="frame" xyz="-0.5 0.5 0" stiffness="100 kN/m" lateral="80 kN/m" longitudinal="20 kN/m"/>
<fp:tyre name="RR" link="frame" xyz="-0.5 -0.5 0" stiffness="100 kN/m" lateral="80 kN/m" longitudinal="20 kN/m"/>
</robot>
)";

TEST(ModeNames, OfAFrameOnItsTyresAreThoseOfAChassis) {
  const Vehicle vehicle = VehicleOf(kKart);
  EXPECT_THAT(Names(vehicle),
              UnorderedElementsAre("heave", "pitch", "roll", "fore-aft", "lateral", "yaw", "seat heave"));
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  EXPECT_EQ(summary.suspension.bodies[static_cast<std::size_t>(summary.suspension.chassis)].name, "frame");
  // Its wheels cannot move against it: the tyre is all that rides, and nothing is unsprung.
  for (const WheelRates& rates : summary.ride.wheels) {
    EXPECT_EQ(rates.alone.wheel_Npm, std::numeric_limits<double>::infinity());
    EXPECT_EQ(rates.alone.ride_Npm, 100e3);
  }
  EXPECT_FALSE(summary.SprungMass_kg().has_value());
}

TEST(ModeNames, TellHopFromTrampOfBeamAxles) {
  EXPECT_THAT(Names(ShippedVehicle("landrover110_model3")),
              ElementsAre("roll", "heave", "pitch", "front hop", "rear hop", "front tramp", "rear tramp"));
}

TEST(ModeNames, TellHopFromTrampOfIndependentWheels) {
  EXPECT_THAT(Names(VehicleOf(kIndependentCar)),
              UnorderedElementsAre("heave", "pitch", "roll", "fore-aft", "lateral", "yaw", "front hop", "front tramp",
                                   "rear hop", "rear tramp"));
}

// Without its bar and with unlike tyres, each front wheel hops for itself.
TEST(ModeNames, TellTheSideOfAWheelThatHopsAlone) {
  Vehicle vehicle = VehicleOf(kIndependentCar);
  vehicle.antiroll_bars.clear();
  vehicle.tyres[0].law.stiffness = {260e3};
  const std::vector<std::string> names = Names(vehicle);
  EXPECT_THAT(names, testing::Contains("front left hop"));
  EXPECT_THAT(names, testing::Contains("front right hop"));
}

TEST(ModeNames, FindWhatAxlesDoOnTheirBushings) {
  EXPECT_THAT(
      Names(VehicleOf(BeamAxleCar())),
      UnorderedElementsAre("heave", "pitch", "lateral", "fore-aft", "yaw", "roll", "engine heave", "front hop",
                           "rear hop", "front lateral", "rear lateral", "front tramp", "rear tramp", "front fore-aft",
                           "rear fore-aft", "front wind-up", "rear wind-up", "front steer", "rear steer"));
}

TEST(ModeNames, TellFreeMotionsApart) {
  Vehicle vehicle = VehicleOf(kIndependentCar);
  for (Tyre& tyre : vehicle.tyres) tyre.lateral = tyre.longitudinal = {};
  const std::vector<Mode> modes = NamedModes(vehicle);
  std::vector<std::string> names;
  for (const Mode& mode : modes)
    if (mode.kind == Mode::Kind::kFree) names.push_back(mode.name);
  EXPECT_THAT(names, UnorderedElementsAre("fore-aft", "lateral", "yaw"));
}

// So stiff a damper locks the wheel to the body: what is left of its hop creeps.
TEST(ModeNames, CallAnOverdampedMotionAfterTheMassesThatItBrakes) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "c_bump", 15e3);
  Set(vehicle, "c_rebound", 15e3);
  const std::vector<Mode> modes = NamedModes(vehicle);
  ASSERT_EQ(modes.size(), 2u);
  for (const Mode& mode : modes) EXPECT_EQ(mode.name, mode.kind == Mode::Kind::kOverdamped ? "wheel hop" : "heave");
}

// A cab on soft mounts rolls below and above the body.
TEST(ModeNames, NumberWhatComesTwice) {
  Diagnostics diagnostics;
  const std::filesystem::path file =
      std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests" / "independent" / "three_wheeler.urdf";
  const std::vector<std::string> names = Names(ReadVehicle(file, diagnostics).value());
  EXPECT_THAT(names, testing::IsSupersetOf({"cab roll", "cab roll 2"}));
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(ModeNames, TellTheSharesOfKineticEnergy) {
  for (const Mode& mode : NamedModes(VehicleOf(BeamAxleCar()))) {
    double sum = 0;
    for (const MotionShare& part : mode.energy) sum += part.share;
    EXPECT_NEAR(sum, 1, 1e-9) << mode.name;  // rounding
    EXPECT_GE(mode.energy.front().share, mode.energy.back().share);
  }
}

}  // namespace
}  // namespace fourpost::mode_names_test
