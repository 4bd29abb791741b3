#include "vehicles/simulation/full_system.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/hydraulic_cars.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/time_history.h"

namespace fourpost::full_system_test {
namespace {

PostMotion Sine(double hertz, double amplitude_m, double duration_s, std::size_t posts) {
  const SweptSine sine{.first_Hz = hertz, .last_Hz = hertz, .duration_s = duration_s, .amplitude_m = amplitude_m};
  return FollowPattern(sine.Signal(), std::vector<double>(posts, 1));
}

PostMotion Random(double rms_m, double duration_s, std::size_t posts) {
  const RandomHeights random{.rms_m = rms_m, .lower_Hz = 0.7, .upper_Hz = 25, .duration_s = duration_s, .seed = 1};
  return FollowPattern(random.Signal(), std::vector<double>(posts, 1));
}

/// Of the steps H and H / 2, each against Simbody's integrator, the largest difference of a channel.
struct Errors {
  double coarse = 0;
  double fine = 0;
};
Errors ErrorsOf(const Vehicle& vehicle, const PostMotion& posts, double duration_s) {
  Prepared car(vehicle);
  const TimeGrid grid{.start_s = 0, .end_s = duration_s, .rate_Hz = 250};
  MultibodySystem reference(car.multibody, 1e-8);
  const TimeHistory exact = Simulate(reference, posts, grid);
  const auto error = [&](FullSystem::Steps steps) {
    FullSystem full(car.multibody, car.model, steps);
    return RelativeDifferences(Simulate(full, posts, grid), exact, vehicle.sensors).maxCoeff();
  };
  // The condensed model's own, for 0.1 %.
  const double part = SimulateCondensed(car.model, RigViewOf(vehicle), posts, grid).step_s;
  return {error({4e-3, part}), error({2e-3, part / 2})};
}

// What histories are asked for, and four times that at twice the step: errors go with its square.
constexpr double kFine = 1e-3;
constexpr double kCoarse = 4e-3;

void ExpectFull(const std::string& name, const Vehicle& vehicle, const PostMotion& posts, double duration_s) {
  const Errors errors = ErrorsOf(vehicle, posts, duration_s);
  EXPECT_LT(errors.coarse, kCoarse) << name;
  EXPECT_LT(errors.fine, kFine) << name;
}

// 100 mm on an arm of 500 mm; linear kinematics are off by 60 % fore and aft.
TEST(FullSystem, IsTheMultibodySystemOnATrailingArm) {
  const Vehicle arm = VehicleOf(SensedTrailingArm());
  ExpectFull("sine", arm, Sine(1, 0.1, 4, 1), 4);
  ExpectFull("random", arm, Random(0.01, 4, 1), 4);
  Vehicle lifting = arm;
  lifting.tyres[0].lifts_off = true;
  ExpectFull("lift-off", lifting, Sine(3, 0.04, 3, 1), 3);
}

// Friction slides at other instants in the two systems.
TEST(FullSystem, IsTheMultibodySystemWithMountsAndFriction) {
  Vehicle arm = VehicleOf(SensedTrailingArm());
  arm.dampers[0].law.friction = DashpotDescription::Friction{{270}, {0.002}};
  ExpectFull("friction", arm, Sine(1, 0.1, 3, 1), 3);
  ExpectFull("friction, random", arm, Random(0.005, 3, 1), 3);
  arm.dampers[0].law.friction = DashpotDescription::Friction{.force = {270}, .speed = {}, .stiffness = Scalar{1e6}};
  ExpectFull("friction that sticks", arm, Sine(1, 0.1, 3, 1), 3);
  ExpectFull("friction that sticks, random", arm, Random(0.005, 3, 1), 3);
  arm.dampers[0].law.friction = DashpotDescription::Friction{{270}, {0.002}};
  arm.dampers[0].series = SpringDescription{.stiffness = {500e3}};
  ExpectFull("mount and friction", arm, Sine(1, 0.1, 3, 1), 3);
  ExpectFull("mount and friction, random", arm, Random(0.005, 3, 1), 3);
}

TEST(FullSystem, IsTheMultibodySystemWithLoops) {
  for (const char* name : {"landrover110_linkage", "landrover110_rigid", "independent_roadster", "landrover110"}) {
    const Vehicle vehicle = ShippedVehicle(name);
    ExpectFull(name, vehicle, Random(0.005, 1, vehicle.posts.size()), 1);
  }
}

TEST(FullSystem, IsTheMultibodySystemOnHydraulicDampers) {
  ExpectFull("hydraulic", LinkageCarOnMixedDampers(), Random(0.005, 2, 2), 2);
}

TEST(FullSystem, EvaluatesTheFullSystemAFewTimesAStep) {
  Prepared car(VehicleOf(SensedTrailingArm()));
  FullSystem full(car.multibody, car.model, {4e-3, 1e-3});
  Simulate(full, Sine(1, 0.1, 4, 1), {.start_s = 0, .end_s = 4, .rate_Hz = 250});
  EXPECT_GT(full.evaluations(), 1000);
  EXPECT_LT(full.evaluations(), 4000);
}

TEST(FullSystem, LeavesThePostsAtRest) {
  Prepared car(VehicleOf(SensedTrailingArm()));
  const Eigen::VectorXd rest = car.multibody.RestState();
  const Eigen::VectorXd before = car.multibody.Readings(0.5, rest);
  FullSystem full(car.multibody, car.model, {});
  Simulate(full, Sine(1, 0.1, 1, 1), {.start_s = 0, .end_s = 1, .rate_Hz = 250});
  EXPECT_EQ(car.multibody.Readings(0.5, rest), before);
}

TEST(FullSystem, RefusesStepsThatAreNone) {
  Prepared car(VehicleOf(SensedTrailingArm()));
  EXPECT_THROW(FullSystem(car.multibody, car.model, {0, 1e-3}), std::invalid_argument);
  EXPECT_THROW(FullSystem(car.multibody, car.model, {1e-3, NAN}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::full_system_test
