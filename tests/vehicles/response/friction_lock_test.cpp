#include "vehicles/response/friction_lock.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::friction_lock_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Vehicle StiffRubbingCar(double force) {
  Vehicle vehicle = Describe(BilinearCar());
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{.force = {force}, .speed = {0.01}};
  return vehicle;
}

TEST(FrictionLock, IsFoundWhereFrictionHoldsAndNotWhereItSlides) {
  const Excitation excitation{{1, 2}, {0.002, 0.002}, {1}};
  const auto locked = FindLockedFriction(StiffRubbingCar(2000), excitation);
  ASSERT_EQ(locked.size(), 1u);
  EXPECT_EQ(locked[0].damper, 0u);
  EXPECT_EQ(locked[0].friction_N, 2000);
  EXPECT_GT(locked[0].factor, 1);
  EXPECT_EQ(locked[0].frequency_Hz, 2);
  EXPECT_THAT(FindLockedFriction(StiffRubbingCar(5), excitation), IsEmpty());
  EXPECT_THAT(FindLockedFriction(Describe(BilinearCar()), excitation), IsEmpty());
  // So many times the motion makes it slide: somewhat more does, somewhat less does not.
  const auto scaled = [&](double scale) {
    Excitation other = excitation;
    for (double& amplitude : other.amplitude_m) amplitude *= scale * locked[0].factor;
    return FindLockedFriction(StiffRubbingCar(2000), other);
  };
  EXPECT_THAT(scaled(1.5), IsEmpty());
  EXPECT_THAT(scaled(0.7), testing::SizeIs(1));
}

// A spring of its own yields while friction holds: below 2000 N / 1 MN/m of extension.
TEST(FrictionLock, IsFoundWhereFrictionSticks) {
  Vehicle vehicle = StiffRubbingCar(2000);
  vehicle.dampers[0].law.friction->stiffness = Scalar{1e6};
  EXPECT_EQ(FindLockedFriction(vehicle, {{1, 2}, {0.002, 0.002}, {1}}).size(), 1u);
  EXPECT_THAT(FindLockedFriction(vehicle, {{1, 2}, {0.1, 0.1}, {1}}), IsEmpty());
}

// The mount yields while the damper behind it holds.
TEST(FrictionLock, IsFoundBehindAMount) {
  Vehicle vehicle = StiffRubbingCar(2000);
  vehicle.dampers[0].series = SpringDescription{.stiffness = {150e3}};
  EXPECT_EQ(FindLockedFriction(vehicle, {{1, 2}, {0.002, 0.002}, {1}}).size(), 1u);
  EXPECT_THAT(FindLockedFriction(vehicle, {{1, 2}, {0.1, 0.1}, {1}}), IsEmpty());
}

constexpr double kRate_Hz = 1000;

/// Its damper holds up to 100 N, and slides from 10 mm/s on.
Vehicle RubbingCar() {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{.force = {100}, .speed = {0.01}};
  return vehicle;
}

/// Three seconds of 2 Hz.
Eigen::MatrixXd Sine(double amplitude) {
  Eigen::MatrixXd extensions(3000, 1);
  for (Eigen::Index k = 0; k < extensions.rows(); ++k)
    extensions(k, 0) = amplitude * std::sin(4 * std::numbers::pi * static_cast<double>(k) / kRate_Hz);
  return extensions;
}

TEST(FrictionLock, OfAHistoryIsToldByItsLargestRate) {
  const double sliding = 0.01 / (4 * std::numbers::pi);
  EXPECT_THAT(FindLockedFriction(RubbingCar(), Sine(1.01 * sliding), kRate_Hz), IsEmpty());
  const auto locked = FindLockedFriction(RubbingCar(), Sine(0.25 * sliding), kRate_Hz);
  ASSERT_THAT(locked, SizeIs(1));
  EXPECT_EQ(locked[0].friction_N, 100);
  EXPECT_EQ(locked[0].frequency_Hz, 0);
  // Differences of samples, half a sample from the largest rate, miss (w / rate)^2 / 6 of it.
  EXPECT_NEAR(locked[0].factor, 4, 4 * std::pow(4 * std::numbers::pi / kRate_Hz, 2) / 5);
}

TEST(FrictionLock, OfAHistoryBehindAMountIsToldByItsLargestExtension) {
  Vehicle vehicle = RubbingCar();
  vehicle.dampers[0].series = SpringDescription{.stiffness = {100e3}};
  EXPECT_THAT(FindLockedFriction(vehicle, Sine(1.01e-3), kRate_Hz), IsEmpty());
  EXPECT_THAT(FindLockedFriction(vehicle, Sine(0.99e-3), kRate_Hz), SizeIs(1));
}

TEST(FrictionLock, OfAHistoryLeavesOutWhatTheMotionDoesNotReach) {
  EXPECT_THAT(FindLockedFriction(RubbingCar(), Sine(1e-12), kRate_Hz), IsEmpty());
  EXPECT_THAT(FindLockedFriction(ShippedVehicle("quarter_car"), Eigen::MatrixXd(3000, 0), kRate_Hz), IsEmpty());
  EXPECT_THROW(FindLockedFriction(RubbingCar(), Eigen::MatrixXd(3000, 2), kRate_Hz), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::friction_lock_test
