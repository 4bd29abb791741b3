#include "vehicles/modes.h"

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed_vehicle.h"

namespace fourpost {
namespace {

std::vector<std::string> Names(const std::vector<Mode>& modes) {
  std::vector<std::string> names;
  for (const Mode& mode : modes) names.push_back(mode.name);
  return names;
}

TEST(Modes, OfTheQuarterCarAreThoseOfTheThesis) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  const std::vector<Mode> modes = ModesOf(CondensedVehicle(vehicle), vehicle.ParameterValues());
  ASSERT_EQ(modes.size(), 2u);
  // The digits of specification 1.1.
  EXPECT_NEAR(modes[0].frequency_Hz, 1.3647, 0.5e-4);
  EXPECT_NEAR(modes[0].damping_ratio, 0.401, 0.5e-3);
  EXPECT_NEAR(modes[1].frequency_Hz, 16.436, 0.5e-3);
  EXPECT_NEAR(modes[1].damping_ratio, 0.333, 0.5e-3);
  EXPECT_THAT(Names(modes), testing::ElementsAre("heave", "wheel hop"));
}

TEST(Modes, OfTheLinkageCarAreNamedByWhatMoves) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const std::vector<Mode> modes = ModesOf(CondensedVehicle(vehicle), vehicle.ParameterValues());
  EXPECT_THAT(Names(modes), testing::UnorderedElementsAre("heave", "pitch", "front hop", "rear hop"));
}

TEST(Modes, ASeriesSpringAddsAStateButNoMode) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].series = SpringDescription{.stiffness = {5e6}};
  const CondensedVehicle condensed(vehicle);
  EXPECT_EQ(StateMatrix(condensed.At(vehicle.ParameterValues())).rows(), 5);
  const std::vector<Mode> modes = ModesOf(condensed, vehicle.ParameterValues());
  ASSERT_EQ(modes.size(), 2u);
  // A spring 300 times as stiff as the suspension's: nearly the rigid damper.
  EXPECT_NEAR(modes[0].damping_ratio, 0.401, 0.01);
}

}  // namespace
}  // namespace fourpost
