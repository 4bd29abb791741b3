#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/suggest/addition_source.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::damper_additions_test {
namespace {

/// The quarter car with another law.
Vehicle QuarterCar(const std::string& law) {
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf/quarter_car.urdf";
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  const std::string bilinear = R"(<bilinear bump="$c_bump" rebound="$c_rebound"/>)";
  changed.replace(changed.find(bilinear), bilinear.size(), law);
  if (law.find("$c_rebound") == std::string::npos) {
    // A parameter that nothing uses is an error.
    const std::size_t begin = changed.find("<fp:parameter name=\"c_rebound\"");
    changed.erase(begin, changed.find("/>", begin) + 2 - begin);
  }
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicleText(changed, file, findings);
  EXPECT_TRUE(vehicle) << findings.Format();
  return *vehicle;
}

std::vector<Addition> Of(const Vehicle& vehicle, const std::string& mechanism) {
  std::vector<Addition> all;
  AddDamperAdditions(AdditionSource(vehicle, vehicle.ParameterValues()), all);
  std::vector<Addition> found;
  for (Addition& one : all)
    if (one.mechanism == mechanism) found.push_back(std::move(one));
  return found;
}

/// With the addition's parameters at an amount.
Vehicle With(const Vehicle& vehicle, const Addition& addition, double amount) {
  Diagnostics findings;
  std::optional<Vehicle> with = ReadVehicleText(addition.vehicle, vehicle.file, findings);
  EXPECT_TRUE(with) << findings.Format();
  const std::vector<double> values = addition.values(amount);
  EXPECT_EQ(values.size(), addition.parameters.size());
  for (Parameter& parameter : with->parameters)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (parameter.name == addition.parameters[i]) parameter.value = values[i];
  return *with;
}

double ForceOf(const Vehicle& vehicle, double speed) {
  return vehicle.dampers.at(0).law.At(vehicle.ParameterValues()).Force(speed);
}

constexpr const char* kLinear = R"(<linear rate="$c_bump"/>)";
constexpr const char* kShared = R"(<bilinear bump="$c_bump" rebound="$c_bump"/>)";
constexpr const char* kOwn = R"(<bilinear bump="$c_bump" rebound="$c_rebound"/>)";

// A knee of one direction at a low speed is another rate of that direction, with a number more.
TEST(DamperAdditions, HaveKneesOfOneDirectionWhereItsRateIsItsOwn) {
  EXPECT_EQ(Of(QuarterCar(kOwn), "digression").size(), 13u);
  for (const char* law : {kLinear, kShared}) {
    const Vehicle car = QuarterCar(law);
    std::vector<Addition> found = Of(car, "digression");
    ASSERT_EQ(found.size(), 5u) << law;
    found.pop_back();  // levels off without a knee
    for (const Addition& one : found) {
      EXPECT_EQ(one.count, 2);
      const Vehicle with = With(car, one, 0.6);
      for (const double speed : {0.02, 0.5}) EXPECT_DOUBLE_EQ(ForceOf(with, speed), -ForceOf(with, -speed));
      EXPECT_LT(ForceOf(with, 1), 0.8 * ForceOf(car, 1));
    }
  }
}

// F = c v / (1 + |v| / speed) is half of c v at the speed.
TEST(DamperAdditions, LetTheForceLevelOff) {
  for (const char* law : {kLinear, kOwn}) {
    const Vehicle car = QuarterCar(law);
    const Addition one = Of(car, "digression").back();
    EXPECT_EQ(one.count, law == kLinear ? 1 : 2);
    const Vehicle with = With(car, one, 2);
    for (const double speed : {-0.5, 0.5}) EXPECT_DOUBLE_EQ(ForceOf(with, speed), ForceOf(car, speed) / 2);
  }
}

// Far above the speed the rates are those of bump and rebound, and nothing is changed where they are one.
TEST(DamperAdditions, LetRatesPassIntoEachOther) {
  EXPECT_TRUE(Of(QuarterCar(kLinear), "smooth_passage").empty());
  const Vehicle car = QuarterCar(R"(<bilinear bump="$c_bump" rebound="2*$c_rebound"/>)");
  const std::vector<Addition> found = Of(car, "smooth_passage");
  ASSERT_EQ(found.size(), 1u);
  const Vehicle with = With(car, found[0], 0.01);
  // 1 - tanh(100) is below rounding.
  for (const double speed : {-1.0, 1.0}) EXPECT_DOUBLE_EQ(ForceOf(with, speed), ForceOf(car, speed));
  const double mean = (ForceOf(car, 1) - ForceOf(car, -1)) / 2;
  EXPECT_NEAR(ForceOf(with, 1e-6), mean * 1e-6, 1e-3 * mean * 1e-6);  // tanh(1e-4)
}

TEST(DamperAdditions, GiveBumpAndReboundRatesOfTheirOwn) {
  EXPECT_TRUE(Of(QuarterCar(kOwn), "bump_rebound").empty());
  for (const char* law : {kLinear, kShared}) {
    const Vehicle car = QuarterCar(law);
    const std::vector<Addition> found = Of(car, "bump_rebound");
    ASSERT_EQ(found.size(), 1u) << law;
    const Vehicle with = With(car, found[0], std::log(2.0));
    EXPECT_DOUBLE_EQ(ForceOf(with, -0.3), ForceOf(car, -0.3));
    EXPECT_DOUBLE_EQ(ForceOf(with, 0.3), 2 * ForceOf(car, 0.3));
  }
}

// As growth goes on from a knee that both directions share.
TEST(DamperAdditions, GiveThemBeyondASharedKneeAsWell) {
  const Vehicle linear = QuarterCar(kLinear);
  const Vehicle car = With(linear, Of(linear, "digression").at(1), 0.5);
  const std::vector<Addition> found = Of(car, "bump_rebound");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].count, 2);
  const Vehicle with = With(car, found[0], std::log(2.0));
  for (const double speed : {0.05, 0.5}) {
    EXPECT_DOUBLE_EQ(ForceOf(with, -speed), ForceOf(car, -speed));
    EXPECT_DOUBLE_EQ(ForceOf(with, speed), 2 * ForceOf(car, speed));
  }
  EXPECT_TRUE(Of(with, "bump_rebound").empty());
}

}  // namespace
}  // namespace fourpost::damper_additions_test
