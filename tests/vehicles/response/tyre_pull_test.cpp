#include "vehicles/response/tyre_pull.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/gravity.h"
#include "vehicles/response/findings.h"

namespace fourpost::tyre_pull_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// With linear dampers and a tyre that may pull.
Vehicle LinearCar() {
  Vehicle vehicle = Describe(ThesisCar());
  vehicle.tyres[0].lifts_off = false;
  return vehicle;
}

/// Tyre force per post height of the thesis's car, written out [N/m].
std::complex<double> TyreForce(double frequency_Hz) {
  const QuarterCar car = ThesisCar();
  const std::complex<double> iw(0, 2 * std::numbers::pi * frequency_Hz);
  const std::complex<double> strut = car.stiffness + iw * 1500.0;
  const std::complex<double> body = car.sprung_mass * iw * iw + strut;
  const std::complex<double> wheel = car.unsprung_mass * iw * iw + strut + car.tyre_stiffness - strut * strut / body;
  return car.tyre_stiffness * (1.0 - car.tyre_stiffness / wheel);
}

TEST(TyrePull, CountsTheFrequenciesAtWhichALinearTyrePulls) {
  const double weight = (ThesisCar().sprung_mass + ThesisCar().unsprung_mass) * kGravity;
  const double amplitude = 1.001 * weight / std::abs(TyreForce(10));
  const double less = 0.999 * weight / std::abs(TyreForce(14));
  const Vehicle vehicle = LinearCar();
  const Excitation excitation{{10, 14}, {amplitude, less}, {1}};
  const auto pulls = FindTyrePulls(vehicle, vehicle.ParameterValues(), excitation);
  ASSERT_THAT(pulls, SizeIs(1));
  EXPECT_EQ(pulls[0].tyre, 0u);
  EXPECT_EQ(pulls[0].count, 1u);
  EXPECT_EQ(pulls[0].of, 2u);
  EXPECT_NEAR(pulls[0].pull_N, 0.001 * weight, 1e-6 * weight);  // The printed digits of kGravity.
}

TEST(TyrePull, IsNoneOfTyresThatLiftOff) {
  Vehicle vehicle = LinearCar();
  const Excitation large{{10}, {0.03}, {1}};
  EXPECT_THAT(FindTyrePulls(vehicle, vehicle.ParameterValues(), large), SizeIs(1));
  vehicle.tyres[0].lifts_off = true;
  EXPECT_THAT(FindTyrePulls(vehicle, vehicle.ParameterValues(), large), IsEmpty());
}

TEST(TyrePull, CountsTheSamplesOfAHistory) {
  const Vehicle vehicle = LinearCar();
  const Eigen::VectorXd forces{{0, -900, -1100, -1300, 200}};
  const auto pulls = FindTyrePulls(vehicle, {1000}, forces);
  ASSERT_THAT(pulls, SizeIs(1));
  EXPECT_EQ(pulls[0].count, 2u);
  EXPECT_EQ(pulls[0].of, 5u);
  EXPECT_EQ(pulls[0].pull_N, 300);
  EXPECT_THAT(FindTyrePulls(vehicle, {1500}, forces), IsEmpty());
  EXPECT_THROW(FindTyrePulls(vehicle, {1000}, Eigen::MatrixXd(5, 2)), std::invalid_argument);
}

TEST(TyrePull, WarnsWithTheRemedy) {
  Diagnostics findings;
  WarnOfPulls(LinearCar(), {{.tyre = 0, .count = 312, .of = 6000, .pull_N = 2202}}, "samples", "this motion", findings);
  EXPECT_THAT(findings, Reports(kTyrePulls, {"312 of 6000 samples of this motion", "-2202 N"}));
}

}  // namespace
}  // namespace fourpost::tyre_pull_test
