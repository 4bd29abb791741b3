#include "vehicles/ride/ride_geometry.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost::ride_geometry_test {
namespace {

// Second derivatives by differences over millimetres keep 1e-10 of loads of some kN; rates are some kN/m.
constexpr double kShare = 1e-8;

RideGeometry RideOf(const Vehicle& vehicle) { return Summarise(vehicle, vehicle.ParameterValues()).ride; }

void ExpectShare(double value, double expected) { EXPECT_NEAR(value / expected, 1, kShare); }

TEST(RideGeometry, OfTheQuarterCarIsItsSpring) {
  const RideGeometry ride = RideOf(ShippedVehicle("quarter_car"));
  ASSERT_EQ(ride.wheels.size(), 1u);
  ExpectShare(ride.wheels[0].alone.wheel_Npm, 15e3);
  ExpectShare(ride.wheels[0].alone.ride_Npm, 15e3 * 230e3 / 245e3);
  ExpectShare(ride.wheels[0].together.wheel_Npm, 15e3);
  ExpectShare(ride.springs.at(0).alone.value(), 1);
  ExpectShare(ride.dampers.at(0).alone.value(), 1);
  EXPECT_EQ(ride.springs[0].wheel, 0);
  EXPECT_NEAR(ride.springs[0].length_m, 0.4, 1e-12);  // rounding
  ExpectShare(ride.unsprung_mass_kg.value(), 22);
  EXPECT_FALSE(ride.axles.at(0).roll_Nm);
}

// Coil at half the arm, damper at 0.8 of it, the arm's centre of mass as well.
TEST(RideGeometry, OfATrailingArmGoesByItsLevers) {
  const RideGeometry ride = RideOf(VehicleOf(kTrailingArm));
  ExpectShare(ride.springs.at(0).alone.value(), 0.5);
  ExpectShare(ride.dampers.at(0).alone.value(), 0.8);
  ExpectShare(ride.wheels.at(0).alone.wheel_Npm, 0.25 * 80e3);
  ExpectShare(ride.unsprung_mass_kg.value(), 0.8 * 30);
}

// On an arm that hangs down the coil's lever changes with travel, and its preload shows in the wheel rate. The coil
// stands from (-0.25, -0.1) on the arm to (-0.25, 0.3), the wheel at (-0.5, -0.2), the mass at (-0.4, 0), seen from the
// pivot; a turn by the angle t lifts them.
TEST(RideGeometry, WheelRateHoldsTheChangeOfLeversUnderPreload) {
  std::string text = Replaced(kTrailingArm, R"(link="arm" xyz="-0.5 0 0")", R"(link="arm" xyz="-0.5 0 -0.2")");
  text = Replaced(text, R"(link="arm" xyz="-0.25 0 0")", R"(link="arm" xyz="-0.25 0 -0.1")");
  const auto height = [](double t, double x, double z) { return z * std::cos(t) - x * std::sin(t); };
  const auto lever = [](double t, double x, double z) { return -z * std::sin(t) - x * std::cos(t); };
  const auto length = [&](double t) {
    return std::hypot(-0.25 * std::cos(t) - 0.1 * std::sin(t) + 0.25, height(t, -0.25, -0.1) - 0.3);
  };
  const double step = 1e-5;
  const auto shortening = [&](double t) { return (length(t - step) - length(t + step)) / (2 * step); };
  // The tyre carries all, and the coil what turns the arm.
  const double load = 330 * kGravity;
  const double push = (load * lever(0, -0.5, -0.2) - 30 * kGravity * lever(0, -0.4, 0)) / shortening(0);
  const auto force = [&](double t) {
    const double coil = push + 80e3 * (length(0) - length(t));
    return (coil * shortening(t) + 30 * kGravity * lever(t, -0.4, 0)) / lever(t, -0.5, -0.2);
  };
  const double big = 1e-3;
  const double rate = (force(big) - force(-big)) / (height(big, -0.5, -0.2) - height(-big, -0.5, -0.2));
  EXPECT_NEAR(force(0), load, 1e-6 * load);  // error of the difference
  const double linear = 80e3 * std::pow(shortening(0) / 0.5, 2);
  EXPECT_GT(std::abs(rate / linear - 1), 0.03);  // else this tests nothing
  const RideGeometry ride = RideOf(VehicleOf(text));
  EXPECT_NEAR(ride.wheels.at(0).alone.wheel_Npm / rate, 1, 1e-5);  // square of the steps
  EXPECT_NEAR(ride.springs.at(0).alone.value(), shortening(0) / 0.5, 1e-9);
}

// A beam axle with coils at y = +-a and wheels at +-b: one wheel moved alone moves its coil by (1 + a/b)/2 and the
// other one by (1 - a/b)/2.
TEST(RideGeometry, OfABeamAxleTellsOneWheelFromBoth) {
  const Vehicle vehicle = ShippedVehicle("landrover110_model3");
  const RideGeometry ride = RideOf(vehicle);
  const double share = 0.47 / 0.743;
  const double k = 40e3;
  ExpectShare(ride.wheels.at(0).alone.wheel_Npm, k / 2 * (1 + share * share));
  ExpectShare(ride.wheels.at(0).together.wheel_Npm, k);
  ExpectShare(ride.wheels.at(0).together.ride_Npm, k * 350e3 / (k + 350e3));
  ExpectShare(ride.springs.at(0).alone.value(), (1 + share) / 2);
  ExpectShare(ride.springs.at(0).together.value(), 1);
  EXPECT_EQ(ride.springs[0].wheel, 0);
  EXPECT_EQ(ride.springs[1].wheel, 1);
  ExpectShare(ride.axles.at(0).roll_Nm.value(), 2 * k * 0.47 * 0.47);
  ExpectShare(ride.unsprung_mass_kg.value(), 440);
}

TEST(RideGeometry, CountsTheAntiRollBarWhereWheelsMoveApart) {
  const RideGeometry ride = RideOf(VehicleOf(kIndependentCar));
  const double k = 30e3;
  const double bar = 10e3;
  ExpectShare(ride.wheels.at(0).alone.wheel_Npm, k + bar);
  ExpectShare(ride.wheels.at(0).together.wheel_Npm, k);
  ExpectShare(ride.axles.at(0).roll_Nm.value(), 2 * (k + 2 * bar) * 0.7 * 0.7);
  ExpectShare(std::abs(ride.antiroll_bars.at(0).alone.value()), 1);
  EXPECT_NEAR(ride.antiroll_bars[0].together.value(), 0, 1e-12);  // rounding
  ExpectShare(ride.unsprung_mass_kg.value(), 170);
}

// An axle that slides has no roll: its wheels move together or not at all.
TEST(RideGeometry, TellsAWheelThatCannotMoveAlone) {
  std::string text =
      Replaced(kTrailingArm, R"(type="continuous"><parent link="chassis"/><child link="arm"/><axis xyz="0 1 0"/>)",
               R"(type="prismatic"><parent link="chassis"/><child link="arm"/><axis xyz="0 0 1"/>
                                 <limit effort="0" velocity="0"/>)");
  text =
      Replaced(text, "</robot>", R"(<fp:tyre name="other" link="arm" xyz="-0.5 -1 0" stiffness="100 N/mm"/></robot>)");
  const RideGeometry ride = RideOf(VehicleOf(text));
  EXPECT_TRUE(std::isinf(ride.wheels.at(0).alone.wheel_Npm));
  ExpectShare(ride.wheels[0].alone.ride_Npm, 180e3);
  ExpectShare(ride.wheels[0].together.wheel_Npm + ride.wheels.at(1).together.wheel_Npm, 80e3);
  EXPECT_FALSE(ride.axles.at(0).roll_Nm);
  EXPECT_FALSE(ride.springs.at(0).alone);
  ExpectShare(ride.springs[0].together.value(), 1);
}

TEST(RideGeometry, LeavesOutWhatNoWheelMoves) {
  const RideGeometry ride = RideOf(VehicleOf(BeamAxleCar()));
  EXPECT_EQ(ride.springs.at(0).wheel, -1);
  EXPECT_FALSE(ride.springs[0].alone);
  ExpectShare(ride.unsprung_mass_kg.value(), 440);
  // Each side of an axle turns about its bushing, 0.9 m ahead: 200 N m/rad on that arm, and 3 MN/m that hold its end.
  // In roll the two hold the axle: bodies no longer turn about each other.
  ExpectShare(ride.wheels.at(0).together.wheel_Npm, 40e3 + 1 / (0.9 * 0.9 / 200 + 1 / 3e6));
  EXPECT_GT(ride.wheels[0].alone.wheel_Npm, 10 * 40e3);
}

// Hydraulic dampers with and without friction stand among them.
TEST(RideGeometry, TellsTheMeanRateOfEachDamper) {
  const Vehicle vehicle = ElementCar();
  const RideGeometry ride = RideOf(vehicle);
  const std::map<std::string, double> rates = {{"fl", 1850}, {"tail", 50}, {"torque", 1850}};
  ASSERT_EQ(ride.dampers.size(), vehicle.dampers.size());
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i) {
    const Damper& damper = vehicle.dampers[i];
    if (const auto rate = rates.find(damper.name); rate != rates.end()) ExpectShare(ride.dampers[i].rate, rate->second);
    if (!damper.hydraulic) continue;
    HydraulicDamper law = damper.HydraulicAt(vehicle.ParameterValues());
    law.friction = 0;
    ExpectShare(ride.dampers[i].rate, (law.SteadyForce(0.1) - law.SteadyForce(-0.1)) / 0.2);
  }
}

}  // namespace
}  // namespace fourpost::ride_geometry_test
