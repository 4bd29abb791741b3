#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "identify/suggest/addition_source.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::friction_additions_test {
namespace {

constexpr const char* kMount = R"(<series stiffness="150 kN/m"/>)";
constexpr const char* kMountAndFriction = R"(<series stiffness="150 kN/m"/><friction force="40 N" speed="3 mm/s"/>)";

/// The quarter car with more in its damper, and more elements.
Vehicle QuarterCar(const std::string& in_damper, const std::string& elements = "") {
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf/quarter_car.urdf";
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  const std::string law = R"(<bilinear bump="$c_bump" rebound="$c_rebound"/>)";
  changed.insert(changed.find(law), in_damper);
  changed.insert(changed.rfind("</robot>"), elements);
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicleText(changed, file, findings);
  EXPECT_TRUE(vehicle) << findings.Format();
  return *vehicle;
}

constexpr const char* kBeside = R"(<fp:damper name="seals" parent="strut_top" child="strut_bottom" axis="0 0 1">
  <linear rate="0 N*s/m"/><friction force="40 N" speed="3 mm/s"/></fp:damper>)";
constexpr const char* kDashpotBeside = R"(<fp:damper name="seals" parent="strut_top" child="strut_bottom" axis="0 0 1">
  <linear rate="9 N*s/m"/><friction force="40 N" speed="3 mm/s"/></fp:damper>)";

Vehicle With(const Vehicle& vehicle, const Addition& addition) {
  Diagnostics findings;
  std::optional<Vehicle> with = ReadVehicleText(addition.vehicle, vehicle.file, findings);
  EXPECT_TRUE(with) << findings.Format();
  return *with;
}

std::vector<Addition> Of(const Vehicle& vehicle, const std::string& mechanism) {
  std::vector<Addition> all;
  const AdditionSource source(vehicle, vehicle.ParameterValues());
  AddMountAdditions(source, all);
  AddFrictionAdditions(source, all);
  AddHysteresisAdditions(source, all);
  AddGuideAdditions(source, all);
  std::vector<Addition> found;
  for (Addition& one : all)
    if (one.mechanism == mechanism) found.push_back(std::move(one));
  return found;
}

bool HasFriction(const Damper& damper) {
  return damper.law.friction && damper.law.friction->force.At({}) == 40 && damper.law.friction->speed.At({}) == 0.003;
}

TEST(FrictionAdditions, OfADamperWithoutAMountStandBesideIt) {
  const Vehicle car = QuarterCar("");
  const std::vector<Addition> found = Of(car, "friction");
  ASSERT_EQ(found.size(), 1u);
  const Vehicle with = With(car, found[0]);
  ASSERT_EQ(with.dampers.size(), 2u);
  EXPECT_TRUE(with.dampers[1].law.friction);
  EXPECT_TRUE(Of(car, "friction_behind_mount").empty());
}

// Alternatives for one thing, of which the better is suggested.
TEST(FrictionAdditions, OfADamperWithAMountStandBesideAndBehindIt) {
  const Vehicle car = QuarterCar(kMount);
  const std::vector<Addition> found = Of(car, "friction");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].Key(), found[1].Key());
  EXPECT_EQ(With(car, found[0]).dampers.size(), 2u);
  const Vehicle behind = With(car, found[1]);
  ASSERT_EQ(behind.dampers.size(), 1u);
  EXPECT_TRUE(behind.dampers[0].law.friction && behind.dampers[0].series);
}

TEST(FrictionAdditions, MoveItBehindTheMountAndBack) {
  const Vehicle beside = QuarterCar(kMount, kBeside);
  const std::vector<Addition> found = Of(beside, "friction_behind_mount");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].count, 0);
  EXPECT_TRUE(found[0].parameters.empty());
  EXPECT_TRUE(Of(beside, "friction_beside_mount").empty());
  const Vehicle behind = With(beside, found[0]);
  ASSERT_EQ(behind.dampers.size(), 1u);
  EXPECT_TRUE(HasFriction(behind.dampers[0]));

  const std::vector<Addition> back = Of(behind, "friction_beside_mount");
  ASSERT_EQ(back.size(), 1u);
  EXPECT_TRUE(Of(behind, "friction_behind_mount").empty());
  const Vehicle again = With(behind, back[0]);
  ASSERT_EQ(again.dampers.size(), 2u);
  EXPECT_FALSE(again.dampers[0].law.friction);
  EXPECT_TRUE(HasFriction(again.dampers[1]));
  EXPECT_FALSE(again.dampers[1].series);
}

// Both may be there: seals behind the mount, and a guide beside it.
TEST(FrictionAdditions, OfFrictionBehindAMountStandBesideIt) {
  const std::vector<Addition> found = Of(QuarterCar(kMountAndFriction), "friction");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].words, testing::HasSubstr("beside"));
}

// A guess taken as exact would move rates and force by many standard deviations.
TEST(FrictionAdditions, BringTheirSpeedAsAParameterWithARange) {
  const Vehicle car = QuarterCar(kMount);
  for (const char* mechanism : {"friction", "hysteresis", "guide_friction"}) {
    const std::vector<Addition> found = Of(car, mechanism);
    ASSERT_FALSE(found.empty()) << mechanism;
    for (const Addition& one : found) {
      EXPECT_EQ(one.count, std::ssize(one.parameters)) << one.words;
      EXPECT_EQ(one.values(one.first).size(), one.parameters.size()) << one.words;
      const Vehicle with = With(car, one);
      bool is_found = false;
      for (const Damper& damper : with.dampers) {
        if (!damper.law.friction) continue;
        is_found = true;
        ASSERT_GE(damper.law.friction->speed.parameter, 0) << one.words;
        const Parameter& speed = with.parameters[static_cast<std::size_t>(damper.law.friction->speed.parameter)];
        EXPECT_EQ(one.parameters.at(1), speed.name);
        EXPECT_LT(speed.lower, speed.value);
        EXPECT_LT(speed.value, speed.upper);
      }
      EXPECT_TRUE(is_found) << one.words;
      EXPECT_TRUE(Of(with, "friction_speed").empty()) << one.words;
    }
  }
}

TEST(FrictionAdditions, FreeTheSpeedOverWhichItChangesSign) {
  EXPECT_TRUE(Of(QuarterCar(kMount), "friction_speed").empty());
  const Vehicle car = QuarterCar(kMount, kBeside);
  const std::vector<Addition> found = Of(car, "friction_speed");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].elements, std::vector<std::string>{"seals"});
  EXPECT_DOUBLE_EQ(found[0].values(0).at(0), 0.003);
  const Vehicle with = With(car, found[0]);
  EXPECT_EQ(with.dampers[1].law.friction->speed.parameter, static_cast<int>(with.parameters.size()) - 1);
  EXPECT_TRUE(Of(with, "friction_speed").empty());
}

TEST(MountAdditions, TakeFrictionAlong) {
  const Vehicle car = QuarterCar("", kBeside);
  const std::vector<Addition> found = Of(car, "mount");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].Key(), found[1].Key());
  const Vehicle without = With(car, found[0]);
  ASSERT_EQ(without.dampers.size(), 2u);
  EXPECT_TRUE(without.dampers[0].series && !without.dampers[0].law.friction);
  const Vehicle along = With(car, found[1]);
  ASSERT_EQ(along.dampers.size(), 1u);
  EXPECT_TRUE(along.dampers[0].series && HasFriction(along.dampers[0]));
  EXPECT_EQ(along.parameters.back().name, found[1].parameters.at(0));
  // Friction could be moved alone: that is a second choice.
  EXPECT_EQ(found[0].choices, 1);
  EXPECT_EQ(found[1].choices, 2);
}

// A dashpot of its own is no friction alone, and stays where it is.
TEST(MountAdditions, LeaveADashpotBesideTheDamperWhereItIs) {
  const Vehicle car = QuarterCar("", kDashpotBeside);
  const std::vector<Addition> found = Of(car, "mount");
  ASSERT_FALSE(found.empty());
  for (const Addition& one : found) EXPECT_EQ(With(car, one).dampers.size(), 2u);
}

/// Of the Land Rover with mirrored dampers.
TEST(MountAdditions, TakeFrictionOfBothSidesAlong) {
  Diagnostics findings;
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf/landrover110_model3.urdf";
  const std::optional<Vehicle> car = ReadVehicle(file, findings);
  ASSERT_TRUE(car);
  for (const Addition& friction : Of(*car, "friction")) {
    if (friction.elements.size() < 2) continue;
    const Vehicle with = With(*car, friction);
    bool is_found = false;
    for (const Addition& mount : Of(with, "mount")) {
      if (mount.elements != friction.elements || mount.words.find("its friction") == std::string::npos) continue;
      is_found = true;
      const Vehicle both = With(with, mount);
      EXPECT_EQ(both.dampers.size(), car->dampers.size());
      std::size_t count = 0;
      for (const Damper& damper : both.dampers) count += damper.series && damper.law.friction ? 1 : 0;
      EXPECT_EQ(count, friction.elements.size());
    }
    EXPECT_TRUE(is_found) << friction.words;
  }
}

}  // namespace
}  // namespace fourpost::friction_additions_test
