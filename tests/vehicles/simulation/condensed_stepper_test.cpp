#include "vehicles/simulation/condensed_stepper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/simulation/written_out_cars.h"
#include "vehicles/description/gravity.h"

namespace fourpost::condensed_stepper_test {
namespace {

using State5 = Eigen::Vector<double, 5>;
using State8 = Eigen::Vector<double, 8>;

/// Runs a model to `end` and returns the last [s s' x].
Eigen::VectorXd LastState(const CondensedModel& model, const PostMotion& motion, double step, double end) {
  CondensedStepper stepper(model, step);
  std::vector<PostState> posts(stepper.post_count());
  motion(0, posts);
  stepper.Start(posts);
  const long count = std::lround(end / step);
  for (long k = 1; k <= count; ++k) {
    motion(step * static_cast<double>(k), posts);
    stepper.Step(posts);
  }
  EXPECT_EQ(stepper.unsolved_steps(), 0);
  return stepper.state();
}

double Difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return (a - b).norm() / b.norm(); }

/// The written-out equations of the thesis's Model 1 by another integrator.
State8 WrittenOut(const HalfCar& car, double end) {
  const auto f = [&](double t, const State8& y) -> State8 {
    std::array<PostState, 2> posts;
    HalfCarPosts(t, posts);
    State8 rate;
    rate << y.tail<4>(), car.Acceleration(y.head<4>(), y.tail<4>(), {posts[0].height, posts[1].height});
    return rate;
  };
  constexpr double kStep = 2e-5;
  return RungeKutta4<State8>(f, State8::Zero(), kStep, static_cast<int>(std::lround(end / kStep)) + 1).back();
}

TEST(CondensedStepper, IsTheWrittenOutHalfCarByAnotherIntegrator) {
  const HalfCar car = ThesisHalfCar();
  const State8 expected = WrittenOut(car, 3);
  const double coarse = Difference(LastState(car.Model(), HalfCarPosts, 2e-3, 3), expected);
  const double fine = Difference(LastState(car.Model(), HalfCarPosts, 2.5e-4, 3), expected);
  // h^2 times the motion's own curvature, (2 pi 2.1 Hz)^2 / 12 of it, for the remainder that goes straight in a step.
  EXPECT_LT(coarse, 5e-5);
  EXPECT_GT(coarse, 1e-7);
  // Of second order: an eighth of the step, a 64th of the error; kinks meet steps at random, hence not all of it.
  EXPECT_LT(fine, coarse / 16);
}

// With linear dampers nothing is left but what posts do between samples, of fourth order.
TEST(CondensedStepper, IsExactForLinearVehiclesButForWhatPostsDoBetweenSteps) {
  HalfCar car = ThesisHalfCar();
  car.front_damper = {5000, 5000};
  car.rear_damper = {6500, 6500};
  const State8 expected = WrittenOut(car, 3);
  const double coarse = Difference(LastState(car.Model(), HalfCarPosts, 1e-2, 3), expected);
  const double fine = Difference(LastState(car.Model(), HalfCarPosts, 5e-3, 3), expected);
  // (2 pi 2.1 Hz h)^4 / 384 of the posts' motion.
  EXPECT_LT(coarse, 1e-6);
  EXPECT_LT(fine, coarse / 14);
}

/// A quarter car whose tyre may leave the ground, with a stop: the thesis's equations and these two.
struct RoughCar {
  QuarterCar car;
  SpringLaw stop;
  bool lifts_off = false;

  double Preload() const { return (car.sprung_mass + car.unsprung_mass) * kGravity; }

  CondensedModel Model() const {
    const Eigen::Vector2d strut(1, -1);
    CondensedModel model;
    model.mass = Eigen::Vector2d(car.sprung_mass, car.unsprung_mass).asDiagonal();
    model.damping.setZero(2, 2);
    model.stiffness = car.stiffness * strut * strut.transpose();
    model.stiffness(1, 1) += car.tyre_stiffness;
    model.post_stiffness = Eigen::Vector2d(0, car.tyre_stiffness);
    model.post_damping.setZero(2, 1);
    model.dashpots = {{strut, car.damper, {.stiffness = car.series_stiffness, .knees = {}}}};
    if (!stop.knees.empty()) model.stiffenings = {{strut, stop}};
    if (lifts_off)
      model.liftoffs = {{.direction = Eigen::Vector2d(0, -1),
                         .post = 0,
                         .preload = Preload(),
                         .stiffness = car.tyre_stiffness,
                         .load_cells = {}}};
    return model;
  }

  /// Rate of [z_s z_u z_s' z_u' x].
  State5 Derivative(const State5& state, double ground) const {
    State5 rate = car.Derivative(state, ground);
    const double stop_force = stop.Force(state[0] - state[1]);
    rate[2] -= stop_force / car.sprung_mass;
    rate[3] += stop_force / car.unsprung_mass;
    // What the linear tyre pulls, it does not.
    if (lifts_off)
      rate[3] += std::max(0.0, -(Preload() + car.tyre_stiffness * (ground - state[1]))) / car.unsprung_mass;
    return rate;
  }
};

PostMotion Sine(double amplitude, double hertz) {
  return [=](double t, std::span<PostState> posts) {
    const double w = 2 * std::numbers::pi * hertz;
    posts[0] = {amplitude * (1 - std::cos(w * t)), amplitude * w * std::sin(w * t),
                amplitude * w * w * std::cos(w * t)};
  };
}

State5 WrittenOut(const RoughCar& car, const PostMotion& motion, double end) {
  const auto f = [&](double t, const State5& y) -> State5 {
    std::array<PostState, 1> posts;
    motion(t, posts);
    return car.Derivative(y, posts[0].height);
  };
  constexpr double kStep = 1e-5;
  return RungeKutta4<State5>(f, State5::Zero(), kStep, static_cast<int>(std::lround(end / kStep)) + 1).back();
}

/// Error of the last state at a step, against the written-out equations. Bounds are some three times what it is: of
/// second order, with a factor that the motion's curvature gives.
double Error(const RoughCar& car, const PostMotion& motion, double step) {
  constexpr double kEnd = 2;
  const State5 expected = WrittenOut(car, motion, kEnd);
  const Eigen::VectorXd state = LastState(car.Model(), motion, step, kEnd);
  return Difference(state, expected.head(state.size()));
}

TEST(CondensedStepper, TakesMountsInLineWithDampers) {
  const RoughCar car{.car = SeriesCar()};
  EXPECT_LT(Error(car, Sine(0.01, 3), 1e-3), 5e-5);
  EXPECT_LT(Error(car, Sine(0.01, 3), 1e-4), 1e-6);
}

TEST(CondensedStepper, TakesStops) {
  const RoughCar car{.car = BilinearCar(),
                     .stop = {.knees = {{.at = -0.02, .side = -1, .stiffness = 4e5, .cubic = 2e9}}}};
  const double coarse = Error(car, Sine(0.04, 1.5), 1e-3);
  const double without = Difference(LastState(car.Model(), Sine(0.04, 1.5), 1e-4, 2),
                                    LastState(RoughCar{.car = BilinearCar()}.Model(), Sine(0.04, 1.5), 1e-4, 2));
  ASSERT_GT(without, 0.1);  // the stop is met
  EXPECT_LT(coarse, 1e-5);
  EXPECT_LT(Error(car, Sine(0.04, 1.5), 1e-4), coarse / 10);
}

TEST(CondensedStepper, TakesTyresThatLeaveTheGround) {
  const RoughCar car{.car = BilinearCar(), .stop = {}, .lifts_off = true};
  const PostMotion motion = Sine(0.012, 12);
  const RoughCar glued{.car = BilinearCar()};
  ASSERT_GT(Difference(LastState(car.Model(), motion, 1e-4, 2), LastState(glued.Model(), motion, 1e-4, 2)), 0.1);
  const double coarse = Error(car, motion, 1e-3);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(Error(car, motion, 1e-4), coarse / 10);
}

// 80 N that turn about within 2 mm/s: at 2 ms a step jumps over the turn and must not stall or ring.
TEST(CondensedStepper, TakesFrictionAtAnyStep) {
  RoughCar car{.car = BilinearCar()};
  car.car.damper = car.car.damper.WithFriction(80, 0.002);
  EXPECT_LT(Error(car, Sine(0.005, 2), 2e-3), 2e-2);
  const double coarse = Error(car, Sine(0.005, 2), 4e-4);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(Error(car, Sine(0.005, 2), 1e-4), coarse / 6);
}

// Through the same gates as the vehicle's own motion: with everything at once.
TEST(CondensedStepper, TakesAllAtOnce) {
  RoughCar car{
      .car = SeriesCar(),
      .stop = {.knees = {{.at = -0.02, .side = -1, .stiffness = 4e5}, {.at = 0.03, .side = 1, .stiffness = 3e5}}},
      .lifts_off = true};
  car.car.damper = car.car.damper.WithFriction(80, 0.002);
  EXPECT_LT(Error(car, Sine(0.03, 4), 1e-4), 5e-4);
}

// At h = 20 ms the hop mode turns by more than a quarter in a step.
TEST(CondensedStepper, IsStableAtLongSteps) {
  RoughCar car{.car = SeriesCar(), .stop = {}, .lifts_off = true};
  car.car.damper = car.car.damper.WithFriction(80, 0.002);
  const PostMotion motion = Sine(0.01, 1);
  const double reference = LastState(car.Model(), motion, 1e-4, 20).norm();
  EXPECT_NEAR(LastState(car.Model(), motion, 2e-2, 20).norm(), reference, 0.5 * reference);
}

TEST(CondensedStepper, RestsUntilPostsMove) {
  RoughCar car{.car = SeriesCar(), .stop = {}, .lifts_off = true};
  const PostMotion still = [](double, std::span<PostState> posts) { posts[0] = {}; };
  EXPECT_EQ(LastState(car.Model(), still, 1e-3, 1).norm(), 0);
}

TEST(CondensedStepper, RefusesStepsAndPostsThatDoNotFit) {
  const CondensedModel model = ThesisHalfCar().Model();
  for (const double step : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(CondensedStepper(model, step), std::invalid_argument);
  CondensedStepper stepper(model, 1e-3);
  EXPECT_THROW(stepper.Start(std::vector<PostState>(1)), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::condensed_stepper_test
