#include "vehicles/engine/history_solver.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost::history_solver_test {
namespace {

PostMotion Sine(double amplitude_m, std::size_t posts = 1) {
  const SweptSine sine{.first_Hz = 1, .last_Hz = 1, .duration_s = 3, .amplitude_m = amplitude_m};
  return FollowPattern(sine.Signal(), std::vector<double>(posts, 1));
}

constexpr TimeGrid kGrid{.start_s = 0, .end_s = 3, .rate_Hz = 500};

TEST(HistorySolver, LeavesSmallMotionsToTheReducedModel) {
  const Vehicle arm = VehicleOf(SensedTrailingArm());
  HistorySolver solver(arm);
  const SolvedHistory answer = solver.Solve(Sine(1e-4), kGrid, {});
  EXPECT_EQ(answer.by.engine, Engine::kReduced);
  ASSERT_TRUE(answer.by.kinematics_error);
  EXPECT_GT(answer.by.kinematics_error->share, 1e-6);
  EXPECT_LT(answer.by.kinematics_error->share, kVisibleShare);
  EXPECT_LE(answer.by.change.value(), 1e-3);
  const SolvedHistory reduced = solver.Solve(Sine(1e-4), kGrid, {.engine = Engine::kReduced});
  EXPECT_FALSE(reduced.by.kinematics_error);
  EXPECT_EQ(reduced.history.readings, answer.history.readings);
}

// What Simbody's integrator has linear kinematics off by.
TEST(HistorySolver, AnswersByTheFullGeometryWhereThatShows) {
  Prepared arm(VehicleOf(SensedTrailingArm()));
  HistorySolver solver(arm.vehicle);
  const SolvedHistory answer = solver.Solve(Sine(0.1), kGrid, {});
  EXPECT_EQ(answer.by.engine, Engine::kFull);
  EXPECT_LE(answer.by.change.value(), 1e-3);
  MultibodySystem system(arm.multibody, 1e-8);
  const TimeHistory exact = Simulate(system, Sine(0.1), kGrid);
  // A third of what halving may change.
  EXPECT_LT(LargestDifferenceOf(answer.history, exact, arm.vehicle.sensors).share, 4e-4);
  const SolvedHistory reduced = solver.Solve(Sine(0.1), kGrid, {.engine = Engine::kReduced});
  const HistoryDifference off = LargestDifferenceOf(reduced.history, exact, arm.vehicle.sensors);
  ASSERT_TRUE(answer.by.kinematics_error);
  EXPECT_NEAR(answer.by.kinematics_error->share, off.share, 1e-3);
  EXPECT_EQ(answer.by.kinematics_error->channel, off.channel);
  EXPECT_EQ(off.channel, "a_fore");
  EXPECT_GT(off.share, 0.3);
}

TEST(HistorySolver, ComparesTheSensorsAskedFor) {
  const Vehicle arm = VehicleOf(SensedTrailingArm());
  HistorySolver solver(arm);
  // Without the three that were added.
  const SolvedHistory answer = solver.Solve(Sine(0.02), kGrid, {.compared = 1});
  EXPECT_EQ(answer.by.kinematics_error->channel, "a_chassis");
}

// Of a wheel that moves straight there is no kinematics to be off by.
TEST(HistorySolver, FindsNothingOnAStraightTravel) {
  const Vehicle car = ShippedVehicle("quarter_car");
  const SolvedHistory answer = HistorySolver(car).Solve(Sine(0.02), kGrid, {});
  EXPECT_EQ(answer.by.engine, Engine::kReduced);
  // The tolerance of the full system's steps.
  EXPECT_LT(answer.by.kinematics_error->share, 1e-5);
}

TEST(HistorySolver, EndsWhereItIsAskedTo) {
  const Vehicle arm = VehicleOf(SensedTrailingArm());
  HistorySolver solver(arm);
  std::vector<std::string> works;
  const SolvedHistory answer = solver.Solve(Sine(0.1), kGrid, {}, [&](const std::string& work, double) {
    if (works.empty() || works.back() != work) works.push_back(work);
    return work == "reduced model";
  });
  EXPECT_THAT(works, testing::ElementsAre("reduced model", "full geometry"));
  EXPECT_TRUE(answer.ended);
  EXPECT_EQ(answer.by.engine, Engine::kReduced);
  EXPECT_EQ(answer.history.size(), kGrid.count());
  EXPECT_THAT(answer.by.not_estimated, testing::EndsWith("[interrupted]"));
}

TEST(HistorySolver, RefusesTheMarch) {
  const Vehicle arm = VehicleOf(SensedTrailingArm());
  EXPECT_THROW(HistorySolver(arm).Solve(Sine(0.1), kGrid, {.engine = Engine::kTimeIntegration}), std::invalid_argument);
}

TEST(Engine, KnowsOlderNames) {
  EXPECT_EQ(EngineNamed("condensed"), Engine::kReduced);
  EXPECT_EQ(EngineNamed("linearised"), Engine::kReduced);
  EXPECT_EQ(EngineNamed("reduced"), Engine::kReduced);
  EXPECT_EQ(EngineNamed("auto"), Engine::kAuto);
  EXPECT_FALSE(EngineNamed("ful"));
}

}  // namespace
}  // namespace fourpost::history_solver_test
