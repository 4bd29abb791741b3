#include "vehicles/response/steady_response.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "vehicles/response/amplitude_law.h"
#include "vehicles/response/friction_lock.h"
#include "vehicles/response/march.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(AmplitudeLaw, TheLeastLimitCounts) {
  const double w = 2 * std::numbers::pi;
  const AmplitudeLaw law{.displacement_m = 0.01, .velocity_mps = 0.01 * w, .acceleration_mps2 = 0.02 * w * w};
  EXPECT_EQ(law.At(0.5), 0.01);
  EXPECT_NEAR(law.At(1.5), 0.01 / 1.5, 1e-15);  // rounding
  EXPECT_NEAR(law.At(4), 0.02 / 16, 1e-15);
  EXPECT_EQ(AmplitudeLaw{.displacement_m = 1}.At(100), 1);
}

TEST(SteadyResponse, OfLinearKinematicsIsTheLinearisedOne) {
  const Vehicle vehicle = Describe(BilinearCar());
  const Excitation excitation{{1, 5, 15}, {0.01, 0.005, 0.001}, {1}};
  SteadySolver solver(vehicle);
  const SteadyResponse answer = solver.Solve(excitation, Engine::kAuto);
  EXPECT_EQ(answer.engine, Engine::kLinearised);
  EXPECT_THAT(answer.engine_at, Each(Engine::kLinearised));
  ASSERT_TRUE(answer.kinematics_error);
  EXPECT_FALSE(answer.kinematics_error->IsVisible());
  EXPECT_THAT(answer.unanswered, IsEmpty());
  EXPECT_EQ(answer.response.channels[0].response,
            solver.Solve(excitation, Engine::kLinearised).response.channels[0].response);
}

// Arms of the linkage car turn by so much in a motion of 40 mm that their radius counts.
TEST(SteadyResponse, OfLargeMotionIsThatOfTheFullGeometry) {
  const Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  const Excitation excitation{{1, 1.6}, {0.04, 0.04}, {1, 1}};
  SteadySolver solver(vehicle);
  const SteadyResponse answer = solver.Solve(excitation, Engine::kAuto);
  ASSERT_TRUE(answer.kinematics_error);
  EXPECT_TRUE(answer.kinematics_error->IsVisible());
  EXPECT_FALSE(answer.kinematics_error->gain_dB.channel.empty());
  EXPECT_EQ(answer.engine, Engine::kFull);
  EXPECT_TRUE(answer.linearised);
  EXPECT_EQ(answer.response.channels[0].response,
            solver.Solve(excitation, Engine::kFull).response.channels[0].response);
}

// A single iteration at the fewest harmonics converges nowhere: the march answers in its place.
TEST(SteadyResponse, MarchesWhereTheBalanceDoesNotConverge) {
  const Vehicle vehicle = Describe(BilinearCar());
  const Excitation excitation{{2, 5}, {0.01, 0.005}, {1}};
  SteadySolver solver(vehicle);
  std::vector<std::string> heard;
  const SteadyResponse answer =
      solver.Solve(excitation, Engine::kLinearised, {.error = 1e-15, .most_harmonics = 9, .max_iterations = 1},
                   [&](const std::string& text) { heard.push_back(text); });
  EXPECT_THAT(answer.engine_at, ElementsAre(Engine::kMarch, Engine::kMarch));
  EXPECT_THAT(heard, ElementsAre("march: 0 of 2 frequencies", "march: 1 of 2 frequencies"));
  const SteadyResponse marched = solver.Solve(excitation, Engine::kMarch);
  EXPECT_EQ(marched.engine, Engine::kMarch);
  EXPECT_EQ(answer.response.channels[0].response, marched.response.channels[0].response);
  EXPECT_EQ(answer.response.channels[0].mean, marched.response.channels[0].mean);
}

// Where nothing was compared no error is known.
TEST(SteadyResponse, TellsThatItCouldNotEstimate) {
  const Vehicle vehicle = Describe(BilinearCar());
  const SteadyResponse answer = SteadySolver(vehicle).Solve({{5}, {0.005}, {1}}, Engine::kAuto,
                                                            {.error = 1e-15, .most_harmonics = 9, .max_iterations = 1});
  EXPECT_FALSE(answer.kinematics_error);
  EXPECT_THAT(answer.not_estimated, HasSubstr("converged at no frequency"));
  EXPECT_THAT(answer.engine_at, ElementsAre(Engine::kFull));
}

// A tenth of a newton second per metre: heave rings for an hour.
TEST(SteadyResponse, HasNoValueWhereNothingSettles) {
  Vehicle vehicle = Describe(ThesisCar());
  Set(vehicle, "c_bump", 0.1);
  Set(vehicle, "c_rebound", 0.1);
  const SteadyResponse answer = SteadySolver(vehicle).Solve({{3}, {0.001}, {1}}, Engine::kMarch);
  ASSERT_EQ(answer.unanswered.size(), 1u);
  EXPECT_EQ(answer.unanswered[0].frequency_Hz, 3);
  EXPECT_THAT(answer.unanswered[0].why, HasSubstr("no periodic motion within 60 s"));
  EXPECT_TRUE(std::isnan(std::abs(answer.response.channels[0].response[0])));
  EXPECT_TRUE(std::isnan(answer.response.channels[0].mean[0]));
}

FrequencyResponse Two(std::complex<double> first, std::complex<double> second) {
  return {.frequency_Hz = {1, 2}, .channels = {{.name = "a", .unit = "m", .response = {first, second}}}};
}

TEST(KinematicsError, IsTheLargestDifferenceOfGainAndOfPhase) {
  const KinematicsError error = CompareKinematics(Two(1.1, 1), Two(1, std::polar(1.0, -0.1)));
  EXPECT_NEAR(error.gain_dB.value, 20 * std::log10(1.1), 1e-12);  // rounding
  EXPECT_EQ(error.gain_dB.frequency_Hz, 1);
  EXPECT_EQ(error.gain_dB.channel, "a");
  EXPECT_NEAR(error.phase_deg.value, 0.1 * 180 / std::numbers::pi, 1e-12);
  EXPECT_EQ(error.phase_deg.frequency_Hz, 2);
  EXPECT_TRUE(error.IsVisible());
}

TEST(KinematicsError, LeavesOutNodesSilenceAndWhatHasNoAnswer) {
  EXPECT_FALSE(CompareKinematics(Two(1, 0.01), Two(1, 0.02)).IsVisible());
  EXPECT_FALSE(CompareKinematics(Two(1, std::nan("")), Two(1, 2)).IsVisible());
  FrequencyResponse one = Two(1, 1);
  FrequencyResponse other = one;
  one.channels.push_back({.name = "silent", .unit = "m", .response = {1e-9, 1e-9}});
  other.channels.push_back({.name = "silent", .unit = "m", .response = {2e-9, 1e-9}});
  EXPECT_FALSE(CompareKinematics(one, other).IsVisible());
}

Vehicle RubbingCar(double force) {
  Vehicle vehicle = Describe(BilinearCar());
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{.force = {force}, .speed = {0.01}};
  return vehicle;
}

TEST(FrictionLock, IsFoundWhereFrictionHoldsAndNotWhereItSlides) {
  const Excitation excitation{{1, 2}, {0.002, 0.002}, {1}};
  const auto locked = FindLockedFriction(RubbingCar(2000), excitation);
  ASSERT_EQ(locked.size(), 1u);
  EXPECT_EQ(locked[0].damper, 0u);
  EXPECT_EQ(locked[0].friction_N, 2000);
  EXPECT_GT(locked[0].factor, 1);
  EXPECT_EQ(locked[0].frequency_Hz, 2);
  EXPECT_THAT(FindLockedFriction(RubbingCar(5), excitation), IsEmpty());
  EXPECT_THAT(FindLockedFriction(Describe(BilinearCar()), excitation), IsEmpty());
  // So many times the motion makes it slide: somewhat more does, somewhat less does not.
  const auto scaled = [&](double scale) {
    Excitation other = excitation;
    for (double& amplitude : other.amplitude_m) amplitude *= scale * locked[0].factor;
    return FindLockedFriction(RubbingCar(2000), other);
  };
  EXPECT_THAT(scaled(1.5), IsEmpty());
  EXPECT_THAT(scaled(0.7), testing::SizeIs(1));
}

// The mount yields while the damper behind it holds.
TEST(FrictionLock, IsFoundBehindAMount) {
  Vehicle vehicle = RubbingCar(2000);
  vehicle.dampers[0].series = SpringDescription{.stiffness = {150e3}};
  EXPECT_EQ(FindLockedFriction(vehicle, {{1, 2}, {0.002, 0.002}, {1}}).size(), 1u);
  EXPECT_THAT(FindLockedFriction(vehicle, {{1, 2}, {0.1, 0.1}, {1}}), IsEmpty());
}

TEST(PostStroke, IsHalfUpAndHalfDown) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Diagnostics diagnostics;
  const auto check = [&](double excursion) {
    CheckStroke(vehicle, std::vector{excursion}, "heave at 1 Hz", diagnostics);
  };
  check(5);
  vehicle.posts[0].stroke = 0.1;
  check(0.05);
  EXPECT_EQ(diagnostics.Format(), "");
  check(0.0512);
  EXPECT_THAT(diagnostics.Format(),
              HasSubstr("fp:post 'post' reaches 50 mm up and down, and heave at 1 Hz asks 51.2 mm of it"));
  EXPECT_THROW(CheckStroke(vehicle, {}, "", diagnostics), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost
