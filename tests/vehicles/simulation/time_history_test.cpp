#include "vehicles/simulation/time_history.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/hydraulic_cars.h"
#include "tests/vehicles/recorded_rig.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "tests/vehicles/simulation/written_out_cars.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/simulation/condensed_system.h"
#include "vehicles/simulation/multibody_system.h"

namespace fourpost::time_history_test {
namespace {

TEST(TimeGrid, CountsSamplesOfWholeAndBrokenDurations) {
  EXPECT_EQ((TimeGrid{.start_s = 0, .end_s = 1, .rate_Hz = 500}.count()), 501);
  EXPECT_EQ((TimeGrid{.start_s = 0.1, .end_s = 0.3, .rate_Hz = 10}.count()), 3);
  EXPECT_EQ((TimeGrid{.start_s = 0, .end_s = 0.999, .rate_Hz = 500}.count()), 500);
  EXPECT_EQ((TimeGrid{.start_s = 0, .end_s = 1, .rate_Hz = 100, .lead_s = 0.3}.lead_count()), 30);
  EXPECT_EQ((TimeGrid{.start_s = 0, .end_s = 1, .rate_Hz = 100, .lead_s = 0.305}.lead_count()), 31);
  EXPECT_THROW((TimeGrid{.start_s = 0, .end_s = 0, .rate_Hz = 10}.Validate()), std::invalid_argument);
  EXPECT_THROW((TimeGrid{.start_s = 0, .end_s = 1, .rate_Hz = NAN}.Validate()), std::invalid_argument);
  EXPECT_THROW((TimeGrid{.start_s = 0, .end_s = 1, .rate_Hz = 1, .lead_s = -1}.Validate()), std::invalid_argument);
}

TEST(TimeHistory, HoldsPostsAndSensorsAtTheSameTimes) {
  CondensedModel model = ThesisHalfCar().Model();
  CondensedSystem system(model, ReadAll(model));
  const TimeGrid grid{.start_s = 1, .end_s = 2, .rate_Hz = 200, .lead_s = 1};
  TimeHistory history = Simulate(system, HalfCarPosts, grid);
  ASSERT_EQ(history.size(), 401);
  EXPECT_EQ(history.start_s, 0);
  std::array<PostState, 2> posts;
  HalfCarPosts(1.5, posts);
  EXPECT_EQ(history.TimeAt(300), 1.5);
  EXPECT_EQ(history.posts(300, 1), posts[1].height);
  // An acceleration is the second difference of its height; (2 pi 12 Hz / 200 Hz)^2 / 12 of what hop there is.
  const Eigen::VectorXd heave = history.readings.col(0);
  const double second = (heave[301] - 2 * heave[300] + heave[299]) * 200 * 200;
  EXPECT_NEAR(second, history.readings(300, 4), 0.02 * history.readings.col(4).cwiseAbs().maxCoeff());
  history.DropFirst(grid.lead_count());
  EXPECT_EQ(history.start_s, 1);
  EXPECT_EQ(history.size(), 201);
  EXPECT_EQ(history.posts(100, 1), posts[1].height);
}

TEST(TimeHistory, EndsWhereItIsAskedTo) {
  CondensedModel model = ThesisHalfCar().Model();
  CondensedSystem system(model, ReadAll(model));
  const TimeGrid grid{.start_s = 0, .end_s = 20, .rate_Hz = 200};
  const TimeHistory whole = Simulate(system, HalfCarPosts, grid, [](double) { return true; });
  const TimeHistory part = Simulate(system, HalfCarPosts, grid, [](double t) { return t < 9; });
  EXPECT_EQ(whole.size(), 4001);
  // It is asked every 256 samples.
  EXPECT_NEAR(part.TimeAt(part.size() - 1), 9, 256 / 200.0);
  EXPECT_EQ(part.readings, whole.readings.topRows(part.size()));
  EXPECT_EQ(part.posts.rows(), part.size());
}

TEST(CondensedHistory, KeepsTheLastWholeOneWhereItIsEnded) {
  CondensedModel model = ThesisHalfCar().Model();
  const RigView rig = ReadAll(model);
  const TimeGrid grid{.start_s = 0, .end_s = 20, .rate_Hz = 200};
  const auto end_in_run = [&](int last) {
    int run = 0;
    double before = HUGE_VAL;
    return SimulateCondensed(model, rig, HalfCarPosts, grid, {.error = 1e-9}, [&, last](double t) {
      run += t < before ? 1 : 0;
      before = t;
      return run < last || t < 9;
    });
  };
  const CondensedHistory first = end_in_run(1);
  EXPECT_TRUE(first.ended);
  EXPECT_LT(first.history.size(), 2500);
  EXPECT_EQ(first.change, HUGE_VAL);
  const CondensedHistory second = end_in_run(2);
  EXPECT_TRUE(second.ended);
  EXPECT_EQ(second.history.size(), 4001);
  EXPECT_EQ(second.step_s, first.step_s);
  EXPECT_EQ(second.change, HUGE_VAL);
  const CondensedHistory third = end_in_run(3);
  EXPECT_EQ(third.step_s, first.step_s / 2);
  EXPECT_LT(third.change, 1);
}

TEST(CondensedHistory, MeetsItsErrorAndSaysBySteps) {
  CondensedModel model = ThesisHalfCar().Model();
  const RigView rig = ReadAll(model);
  const TimeGrid grid{.start_s = 0, .end_s = 3, .rate_Hz = 200};
  const CondensedHistory exact = SimulateCondensed(model, rig, HalfCarPosts, grid, {.error = 1e-7});
  EXPECT_LE(exact.change, 1e-7);
  const CondensedHistory rough = SimulateCondensed(model, rig, HalfCarPosts, grid, {.error = 1e-3});
  EXPECT_LE(rough.change, 1e-3);
  EXPECT_GT(rough.step_s, 4 * exact.step_s);
  const double error = RelativeDifferences(rough.history, exact.history, rig.sensors).maxCoeff();
  EXPECT_LT(error, rough.change);
  EXPECT_GT(error, rough.change / 10);
}

TEST(CondensedHistory, SaysWhenHalvingDidNotHelp) {
  CondensedModel model = ThesisHalfCar().Model();
  const RigView rig = ReadAll(model);
  const CondensedHistory rough = SimulateCondensed(model, rig, HalfCarPosts, {.start_s = 0, .end_s = 1, .rate_Hz = 200},
                                                   {.error = 1e-12, .most_halvings = 2});
  EXPECT_GT(rough.change, 1e-12);
}

// Stops of 40 kN/mm, 2 mm away, between 220 kg and the body: 70 Hz, of which 20 ms are more than a cycle.
TEST(CondensedHistory, ShortensStepsThatStopsCannotTake) {
  CondensedModel model = ThesisHalfCar().Model();
  for (const CondensedModel::Dashpot& dashpot : std::vector(model.dashpots))
    model.stiffenings.push_back(
        {dashpot.direction,
         {.knees = {{.at = -0.002, .side = -1, .stiffness = 4e7}, {.at = 0.002, .side = 1, .stiffness = 4e7}}}});
  const RigView rig = ReadAll(model);
  const PostMotion posts = [](double t, std::span<PostState> states) {
    HalfCarPosts(t, states);
    for (PostState& post : states) post = {2 * post.height, 2 * post.velocity, 2 * post.acceleration};
  };
  const TimeGrid grid{.start_s = 0, .end_s = 3, .rate_Hz = 50};
  CondensedSystem coarse(model, rig, 0.02);
  EXPECT_THROW(Simulate(coarse, posts, grid), std::runtime_error);
  const CondensedHistory history =
      SimulateCondensed(model, rig, posts, grid, {.error = 1e-2, .longest_step_s = 0.02, .most_halvings = 9});
  EXPECT_LE(history.change, 1e-2);
  EXPECT_LT(history.step_s, 0.006);
}

// A sweep of the linkage car by both engines: they differ by kinematics, as its responses do.
TEST(TimeHistory, OfBothEnginesAgreeOnTheLinkageCar) {
  Prepared car(ShippedVehicle("landrover110_linkage"));
  const SweptSine sweep{.first_Hz = 0.7, .last_Hz = 15, .duration_s = 6, .amplitude_m = 0.004, .top_speed = 0.05};
  const PostMotion posts = FollowPattern(sweep.Signal(), {1, 1});
  const TimeGrid grid{.start_s = 0, .end_s = 6, .rate_Hz = 250};
  const RigView rig = RigViewOf(car.vehicle);
  const CondensedHistory condensed = SimulateCondensed(car.model, rig, posts, grid);
  EXPECT_LE(condensed.change, 1e-3);
  MultibodySystem system(car.multibody, 1e-7);
  const TimeHistory full = Simulate(system, posts, grid);
  const Eigen::ArrayXd differences = RelativeDifferences(condensed.history, full, rig.sensors);
  // 0.075 dB and 0.36 degrees are 1.1 %, promised for responses at the rig's amplitudes.
  EXPECT_LT(differences.maxCoeff(), 0.02);
  EXPECT_GT(differences.maxCoeff(), 1e-5);
}

/// Random heave by both engines; the largest difference of a channel.
double DifferenceOfEngines(const Vehicle& vehicle, double rms_m = 0.001) {
  Prepared car(vehicle);
  const RandomHeights random{.rms_m = rms_m, .lower_Hz = 0.7, .upper_Hz = 25, .duration_s = 2, .seed = 1};
  const PostMotion posts = FollowPattern(random.Signal(), std::vector<double>(car.vehicle.posts.size(), 1));
  const TimeGrid grid{.start_s = 0, .end_s = 2, .rate_Hz = 250};
  const RigView rig = RigViewOf(car.vehicle);
  const CondensedHistory condensed = SimulateCondensed(car.model, rig, posts, grid);
  EXPECT_LE(condensed.change, 1e-3);
  MultibodySystem system(car.multibody, 1e-6);
  return RelativeDifferences(condensed.history, Simulate(system, posts, grid), rig.sensors).maxCoeff();
}

// Of one mass on another on one line there is no kinematics to differ by: the integrators' 0.1 % remain.
TEST(TimeHistory, OfBothEnginesAgreesWithoutKinematics) {
  for (const char* name : {"quarter_car", "single_wheel_station", "landrover110_model1"})
    EXPECT_LT(DifferenceOfEngines(ShippedVehicle(name)), 1e-3) << name;
}

// Bushings, loops, friction, stops, mounts; kinematics differ by some mm over links of a metre.
TEST(TimeHistory, OfBothEnginesAgreesWithKinematics) {
  for (const char* name : {"landrover110", "landrover110_rigid", "independent_roadster"})
    EXPECT_LT(DifferenceOfEngines(ShippedVehicle(name)), 1e-2) << name;
}

// Stiff oil, oil that boils, and mounts.
TEST(TimeHistory, OfBothEnginesAgreesOnHydraulicDampers) {
  Vehicle rubbing = QuarterCarOnOil(Oil(0.6e-6, 1e7, 2.6e6), 400e3);
  rubbing.dampers[0].law.friction = DashpotDescription::Friction{{40}, {0.02}};
  EXPECT_LT(DifferenceOfEngines(QuarterCarOnOil(Oil(0.6e-6, 1e7, 2.6e6)), 0.004), 1e-3);
  EXPECT_LT(DifferenceOfEngines(QuarterCarOnOil(Oil(0.6e-6, 3e7, 2.6e6, 100e6), 100e3), 0.004), 1e-3);
  EXPECT_LT(DifferenceOfEngines(QuarterCarOnOil(Oil(0.05e-6, 1e7, 4e7)), 0.004), 1e-3);
  EXPECT_LT(DifferenceOfEngines(rubbing, 0.004), 1e-3);
  // With kinematics.
  EXPECT_LT(DifferenceOfEngines(LinkageCarOnMixedDampers()), 2e-3);
}

// The body's resonance drives the shut piston of a wide bleed to its end.
TEST(TimeHistory, SaysWhereAPistonMeetsItsEnd) {
  HydraulicDescription oil = Oil(20e-6, 1e5, 1e5);
  oil.rebound_column = oil.compression_column = {0.05};
  const Prepared car(QuarterCarOnOil(oil));
  const SweptSine sweep{.first_Hz = 1.2, .last_Hz = 1.4, .duration_s = 4, .amplitude_m = 0.04, .top_speed = 1};
  const auto simulate = [&] {
    SimulateCondensed(car.model, RigViewOf(car.vehicle), FollowPattern(sweep.Signal(), {1}),
                      {.start_s = 0, .end_s = 4, .rate_Hz = 250}, {.most_halvings = 3});
  };
  EXPECT_THAT(simulate, testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("[forces-not-found]")));
}

}  // namespace
}  // namespace fourpost::time_history_test
