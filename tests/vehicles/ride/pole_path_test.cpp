#include "vehicles/ride/pole_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/named_modes.h"

namespace fourpost::pole_path_test {
namespace {

using testing::ElementsAre;

std::size_t IndexOf(const Vehicle& vehicle, const std::string& parameter) {
  const auto found = std::find_if(vehicle.parameters.begin(), vehicle.parameters.end(),
                                  [&](const Parameter& candidate) { return candidate.name == parameter; });
  return static_cast<std::size_t>(found - vehicle.parameters.begin());
}

std::vector<std::string> Names(const PolePaths& paths) {
  std::vector<std::string> names;
  for (const PolePath& path : paths.paths) names.push_back(path.mode);
  return names;
}

TEST(PolePath, OfTheQuarterCarIsOnePathForEachModeAndEndsWhereTheModesAre) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const PolePaths paths = FollowPoles(vehicle, IndexOf(vehicle, "k"), {5e3, 15e3, 40e3});
  ASSERT_THAT(Names(paths), ElementsAre("heave", "wheel hop"));
  Set(vehicle, "k", 40e3);
  const std::vector<Mode> modes = ModesOf(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  // Rounding of eigenvalues.
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(paths.paths[i].pole.back() - modes[i].pole), 1e-9 * std::abs(modes[i].pole));
}

// With enough damping heave's two poles meet on the real axis and part: a path of its own for each.
TEST(PolePath, TwoPolesThatMeetOnTheRealAxisAreTwoPaths) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  for (const char* rate : {"c_bump", "c_rebound"}) vehicle.parameters[IndexOf(vehicle, rate)].value = 3e3;
  vehicle.dampers[0].law.rebound = vehicle.dampers[0].law.compression;
  const PolePaths paths = FollowPoles(vehicle, IndexOf(vehicle, "c_bump"), {1500, 3000, 6000});
  const auto real_at_end = std::count_if(paths.paths.begin(), paths.paths.end(),
                                         [](const PolePath& path) { return path.pole.back().imag() == 0; });
  const auto real_at_start = std::count_if(paths.paths.begin(), paths.paths.end(),
                                           [](const PolePath& path) { return path.pole.front().imag() == 0; });
  EXPECT_EQ(real_at_start, 0);
  EXPECT_EQ(real_at_end, 2);
}

// Heave and pitch come near each other as one front rate grows; shapes tell which is which. A path must not jump: each
// step of a fine walk is small against the frequency.
TEST(PolePath, DoesNotJumpFromModeToMode) {
  const Vehicle vehicle = ShippedVehicle("landrover110_model3");
  const std::size_t index = IndexOf(vehicle, "k_FL");
  const Parameter& parameter = vehicle.parameters[index];
  std::vector<double> values;
  for (int i = 0; i <= 20; ++i) values.push_back(std::lerp(parameter.lower, parameter.upper, i / 20.0));
  const PolePaths paths = FollowPoles(vehicle, index, values);
  EXPECT_EQ(paths.paths.size(), 7u);
  for (const PolePath& path : paths.paths)
    for (std::size_t i = 1; i < values.size(); ++i)
      EXPECT_LT(std::abs(path.pole[i] - path.pole[i - 1]), 0.1 * std::abs(path.pole[i])) << path.mode << " " << i;
}

// Hops of equal axles exchange their shapes within a per cent of a rate.
TEST(PolePath, HasTheNamesOfTheModesAtTheFilesValue) {
  Vehicle vehicle = ShippedVehicle("landrover110_model1");
  const std::vector<double> own = vehicle.ParameterValues();
  const Kinematics pose = DesignKinematics(vehicle);
  const std::vector<Mode> modes =
      NamedModes(vehicle, pose, SuspensionOf(vehicle, pose, own), CondensedVehicle(vehicle).At(own), own);
  for (const char* name : {"k_front", "m_front", "kt_rear"}) {
    const std::size_t index = IndexOf(vehicle, name);
    const double value = own[index];
    // Neither a value of the plot, nor within it.
    for (const std::vector<double>& values :
         {std::vector{0.9 * value, 1.05 * value}, std::vector{1.1 * value, 1.2 * value}}) {
      std::vector<double> with_own = values;
      with_own.push_back(value);
      const PolePaths paths = FollowPoles(vehicle, index, values);
      const PolePaths through = FollowPoles(vehicle, index, with_own);
      ASSERT_EQ(paths.paths.size(), modes.size()) << name;
      for (const Mode& mode : modes) {
        const auto named = [&](const PolePath& path) { return path.mode == mode.name; };
        const auto path = std::find_if(paths.paths.begin(), paths.paths.end(), named);
        const auto same = std::find_if(through.paths.begin(), through.paths.end(), named);
        ASSERT_NE(path, paths.paths.end()) << mode.name;
        ASSERT_NE(same, through.paths.end()) << mode.name;
        // Rounding of eigenvalues.
        EXPECT_LT(std::abs(same->pole.back() - mode.pole), 1e-9 * std::abs(mode.pole)) << name << " " << mode.name;
        EXPECT_LT(std::abs(path->pole[0] - same->pole[0]), 1e-9 * std::abs(mode.pole)) << name << " " << mode.name;
      }
    }
  }
}

TEST(PolePath, NamesThePolesOfAnOverdampedModeApart) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Set(vehicle, "k", 10e3);
  Set(vehicle, "c_bump", 4000);
  Set(vehicle, "c_rebound", 6000);
  const PolePaths overdamped = FollowPoles(vehicle, IndexOf(vehicle, "k"), {10e3, 20e3});
  EXPECT_THAT(Names(overdamped), ElementsAre("wheel hop, slow pole", "heave", "wheel hop, fast pole"));
  Set(vehicle, "c_bump", 1500);
  Set(vehicle, "c_rebound", 1500);
  const PolePaths parting = FollowPoles(vehicle, IndexOf(vehicle, "c_bump"), {1000, 9000});
  EXPECT_THAT(Names(parting), ElementsAre("heave", "heave, conjugate pole", "wheel hop"));
}

TEST(PolePath, NeedsAValue) { EXPECT_THROW(FollowPoles(ShippedVehicle("quarter_car"), 0, {}), std::invalid_argument); }

}  // namespace
}  // namespace fourpost::pole_path_test
