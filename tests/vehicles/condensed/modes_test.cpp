#include "vehicles/condensed/modes.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::modes_test {
namespace {

using Kind = Mode::Kind;

std::vector<Mode> Modes(const Vehicle& vehicle) {
  return ModesOf(CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
}

std::vector<Kind> Kinds(const std::vector<Mode>& modes) {
  std::vector<Kind> kinds;
  for (const Mode& mode : modes) kinds.push_back(mode.kind);
  return kinds;
}

TEST(Modes, OfTheQuarterCarAreThoseOfTheThesis) {
  const std::vector<Mode> modes = Modes(ShippedVehicle("quarter_car"));
  ASSERT_EQ(modes.size(), 2u);
  // The digits of the thesis's poles.
  EXPECT_NEAR(modes[0].frequency_Hz, 1.3647, 0.5e-4);
  EXPECT_NEAR(modes[0].damping_ratio, 0.401, 0.5e-3);
  EXPECT_NEAR(modes[1].frequency_Hz, 16.436, 0.5e-3);
  EXPECT_NEAR(modes[1].damping_ratio, 0.333, 0.5e-3);
}

TEST(Modes, ASeriesSpringAddsAStateButNoMode) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].series = SpringDescription{.stiffness = {5e6}};
  const CondensedVehicle condensed(vehicle);
  EXPECT_EQ(StateMatrix(condensed.At(vehicle.ParameterValues())).rows(), 5);
  const std::vector<Mode> modes = Modes(vehicle);
  ASSERT_EQ(modes.size(), 2u);
  // The damper's rate becomes c / (1 + s c / k): by |s| c / k = 8.6 1/s 1500 N s/m / 5 MN/m another one. Printed
  // digits.
  EXPECT_NEAR(modes[0].damping_ratio, 0.401, 0.401 * 8.6 * 1500 / 5e6 + 0.5e-3);
}

/// A mass m on a tyre k with damping c.
CondensedModel Block(double k, double c) {
  CondensedModel model;
  model.mass = Eigen::MatrixXd::Constant(1, 1, 50);
  model.stiffness = Eigen::MatrixXd::Constant(1, 1, k);
  model.damping = Eigen::MatrixXd::Constant(1, 1, c);
  return model;
}

TEST(Modes, AnOverdampedMotionIsOneMode) {
  const double w = std::sqrt(2e4 / 50);
  const std::vector<Mode> modes = ModesOf(Block(2e4, 2 * 1.7 * 50 * w));
  ASSERT_EQ(Kinds(modes), std::vector{Kind::kOverdamped});
  EXPECT_NEAR(modes[0].frequency_Hz, w / (2 * std::numbers::pi), 1e-12);  // rounding
  EXPECT_NEAR(modes[0].damping_ratio, 1.7, 1e-12);
  EXPECT_NEAR(modes[0].pole.real(), w * (std::sqrt(1.7 * 1.7 - 1) - 1.7), 1e-11);
}

TEST(Modes, AFreeMotionIsOneModeWithOrWithoutADamper) {
  for (const double damping : {0.0, 300.0}) {
    const std::vector<Mode> modes = ModesOf(Block(0, damping));
    ASSERT_EQ(Kinds(modes), std::vector{Kind::kFree}) << damping;
    EXPECT_EQ(modes[0].frequency_Hz, 0);
  }
}

TEST(Modes, AMotionThatFallsOverDiverges) {
  const std::vector<Mode> modes = ModesOf(Block(-800, 0));
  ASSERT_EQ(Kinds(modes), std::vector{Kind::kDiverging});
  EXPECT_NEAR(modes[0].pole.real(), 4, 1e-12);  // rounding
}

// Wheels on rods of 14 kN s/m hardly move against the body; nothing holds the car where it stands.
TEST(Modes, AreAsManyAsThereAreCoordinates) {
  Vehicle vehicle = VehicleOf(kIndependentCar);
  for (Tyre& tyre : vehicle.tyres) tyre.lateral = tyre.longitudinal = {};
  for (Damper& damper : vehicle.dampers) damper.law.compression = damper.law.rebound = {14e3};
  const std::vector<Mode> modes = Modes(vehicle);
  ASSERT_EQ(modes.size(), 10u);
  const std::vector<Kind> kinds = Kinds(modes);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), Kind::kFree), 3);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), Kind::kOverdamped), 4);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), Kind::kOscillating), 3);
  EXPECT_TRUE(std::is_sorted(modes.begin(), modes.end(),
                             [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; }));
}

}  // namespace
}  // namespace fourpost::modes_test
