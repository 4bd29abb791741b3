// Forces that are given over time, in every engine.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"
#include "tests/vehicles/element_car.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/recorded_posts.h"
#include "vehicles/simulation/condensed_system.h"
#include "vehicles/simulation/full_system.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost::actuator_test {
namespace {

constexpr double kHertz = 1.7;
constexpr double kOmega = 2 * std::numbers::pi * kHertz;

/// A sine that begins softly: 1 - exp(-t^2), at posts at rest.
PostMotion Force(double newton, std::size_t posts) {
  return [=](double t, std::span<PostState> inputs) {
    const double rise = 1 - std::exp(-t * t);
    const double slope = 2 * t * std::exp(-t * t);
    std::fill(inputs.begin(), inputs.end(), PostState());
    inputs[posts] = {.height = newton * rise * std::sin(kOmega * t),
                     .velocity = newton * (slope * std::sin(kOmega * t) + rise * kOmega * std::cos(kOmega * t))};
  };
}

/// With an actuator between body and wheel, or from the ground to the body.
Vehicle ActiveQuarterCar(bool on_ground = false) {
  Vehicle vehicle = WithLinearTyres(ShippedVehicle("quarter_car"));
  vehicle.actuators = {{.name = "active", .line = vehicle.springs[0].line}};
  if (on_ground) {
    vehicle.actuators[0].line.child = {.link = 0, .xyz = {0, 0, 0.2}};
    vehicle.actuators[0].line.axis.reset();
  }
  return vehicle;
}

// Two masses, two springs, a damper and the forces of a tension F: -F on the body, F on the wheel.
TEST(Actuator, MovesAQuarterCarAsItsEquationsSay) {
  const Vehicle vehicle = ActiveQuarterCar();
  const double m = 200, mu = 22, k = 15e3, kt = 230e3, c = 1500, force = 300;
  const std::complex<double> iw(0, kOmega);
  Eigen::Matrix2cd dynamic;
  dynamic << k + iw * c + iw * iw * m, -(k + iw * c), -(k + iw * c), k + kt + iw * c + iw * iw * mu;
  const Eigen::Vector2cd expected = dynamic.inverse() * Eigen::Vector2cd(-force, force);
  const Prepared car(vehicle);
  CondensedSystem system(car.model, RigViewOf(vehicle), 1e-3);
  const TimeHistory history = Simulate(system, Force(force, 1), {.start_s = 0, .end_s = 8, .rate_Hz = 200});
  for (Eigen::Index sample = 1300; sample < history.size(); sample += 7) {
    const std::complex<double> turn = std::exp(iw * history.TimeAt(sample));
    for (Eigen::Index mass = 0; mass < 2; ++mass) {
      const double size = std::abs(expected[mass]);
      // Modes have died down to exp(-20), the ramp to exp(-42); the step errs by (w h)^4.
      EXPECT_NEAR(history.readings(sample, 2 + mass), (expected[mass] * turn).imag(), 1e-6 * size);
      EXPECT_NEAR(history.readings(sample, mass), (iw * iw * expected[mass] * turn).imag(),
                  1e-6 * kOmega * kOmega * size);
    }
  }
}

void ExpectAgreement(const Vehicle& vehicle, double newton, double geometry) {
  Prepared car(vehicle);
  const PostMotion force = Force(newton, vehicle.posts.size());
  const TimeGrid grid{.start_s = 0, .end_s = 3, .rate_Hz = 250};
  MultibodySystem exact(car.multibody, 1e-8);
  const TimeHistory reference = Simulate(exact, force, grid);
  FullSystem full(car.multibody, car.model, {.longest_s = 2e-3, .longest_part_s = 5e-4});
  EXPECT_LT(RelativeDifferences(Simulate(full, force, grid), reference, vehicle.sensors).maxCoeff(), 1e-3);
  CondensedSystem reduced(car.model, RigViewOf(vehicle));
  EXPECT_LT(RelativeDifferences(Simulate(reduced, force, grid), reference, vehicle.sensors).maxCoeff(), geometry);
}

TEST(Actuator, IsTheSameInAllEngines) {
  ExpectAgreement(ActiveQuarterCar(), 300, 1e-3);
  ExpectAgreement(ActiveQuarterCar(true), 300, 1e-3);
  // An arm, on which the line turns: linear kinematics err by some per cent.
  Vehicle arm = VehicleOf(SensedTrailingArm());
  arm.actuators = {{.name = "active", .line = arm.springs[0].line}};
  ExpectAgreement(arm, 400, 0.2);
}

// Work of the force is the energy of masses and springs, without dampers.
TEST(Actuator, GivesTheEnergyThatItsForceTimesItsRateIs) {
  Vehicle vehicle = ActiveQuarterCar();
  Set(vehicle, "c_bump", 1e-6);
  Set(vehicle, "c_rebound", 1e-6);
  Prepared car(vehicle);
  CondensedSystem system(car.model, RigViewOf(vehicle), 2e-4);
  const PostMotion force = Force(300, 1);
  const TimeHistory history = Simulate(system, force, {.start_s = 0, .end_s = 2, .rate_Hz = 5000});
  const double h = 1 / history.rate_Hz;
  const auto body = history.readings.col(2);
  const auto wheel = history.readings.col(3);
  double work = 0;
  std::vector<PostState> inputs(2);
  for (Eigen::Index sample = 1; sample + 1 < history.size(); ++sample) {
    force(history.TimeAt(sample), inputs);
    // A tension does work where the line shortens.
    const double rate = (body[sample + 1] - body[sample - 1] - wheel[sample + 1] + wheel[sample - 1]) / (2 * h);
    work -= inputs[1].height * rate * h;
    if (sample % 500 != 0) continue;
    const double v = (body[sample + 1] - body[sample - 1]) / (2 * h);
    const double vu = (wheel[sample + 1] - wheel[sample - 1]) / (2 * h);
    const double energy = 100 * v * v + 11 * vu * vu + 0.5 * 15e3 * std::pow(body[sample] - wheel[sample], 2) +
                          0.5 * 230e3 * std::pow(wheel[sample], 2);
    EXPECT_NEAR(work, energy, 0.05 + 2e-3 * energy) << sample;  // half a sample of power
  }
  EXPECT_GT(work, 1);
}

TEST(Actuator, IsReadBesideThePosts) {
  const TemporaryFolder folder;
  std::string text = "time,post,active\ns,mm,kN\n";
  for (int k = 0; k < 40; ++k) text += std::to_string(0.01 * k) + ",1," + std::to_string(0.1 * k) + "\n";
  Diagnostics diagnostics;
  const auto posts = ReadRecordedPosts(folder.Write("inputs.csv", text), ActiveQuarterCar(), diagnostics);
  ASSERT_TRUE(posts) << diagnostics.Format();
  std::vector<PostState> now(2);
  posts->motion(0.2, now);
  EXPECT_NEAR(now[0].height, 1e-3, 1e-9);
  EXPECT_NEAR(now[1].height, 2000, 1e-6);
  EXPECT_NEAR(now[1].velocity, 10e3, 1e-3);
}

}  // namespace
}  // namespace fourpost::actuator_test
