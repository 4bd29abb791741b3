#include "vehicles/engine/steady_response.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/march.h"

namespace fourpost::steady_response_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SteadyResponse, OfLinearKinematicsIsTheLinearisedOne) {
  const Vehicle vehicle = Describe(BilinearCar());
  const Excitation excitation{{1, 5, 15}, {0.01, 0.005, 0.001}, {1}};
  SteadySolver solver(vehicle);
  const SteadyResponse answer = solver.Solve(excitation, Engine::kAuto);
  EXPECT_EQ(answer.engine, Engine::kReduced);
  EXPECT_THAT(answer.engine_at, Each(Engine::kReduced));
  ASSERT_TRUE(answer.kinematics_error);
  EXPECT_FALSE(answer.kinematics_error->IsVisible());
  EXPECT_THAT(answer.unanswered, IsEmpty());
  EXPECT_EQ(answer.response.channels[0].response,
            solver.Solve(excitation, Engine::kReduced).response.channels[0].response);
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
      solver.Solve(excitation, Engine::kReduced, {.error = 1e-15, .most_harmonics = 9, .max_iterations = 1},
                   [&](const SteadySolver::Stage& stage) {
                     const std::string text = std::string(stage.work) + ": " + std::to_string(stage.done) + " of " +
                                              std::to_string(stage.total);
                     if (heard.empty() || text != heard.back()) heard.push_back(text);
                     return true;
                   });
  EXPECT_THAT(answer.engine_at, ElementsAre(Engine::kTimeIntegration, Engine::kTimeIntegration));
  EXPECT_THAT(heard, ElementsAre("time integration: 0 of 2", "time integration: 1 of 2"));
  // Time integration of the same model, until windows differ by 1e-4 of a channel; what then is left is some times as
  // much.
  constexpr double kSettled = 1e-3;
  const ChannelResponse& marched = answer.response.channels[0];
  const ChannelResponse balanced = solver.Solve(excitation, Engine::kReduced).response.channels[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const double size = std::abs(balanced.response[i]);
    EXPECT_LT(std::abs(marched.response[i] - balanced.response[i]), kSettled * size);
    EXPECT_LT(std::abs(marched.mean[i] - balanced.mean[i]), kSettled * size * excitation.amplitude_m[i]);
  }
}

TEST(SteadyResponse, MarchesTheFullSystemWhereThatIsAsked) {
  const Vehicle vehicle = Describe(BilinearCar());
  const Excitation excitation{{2}, {0.01}, {1}};
  SteadySolver solver(vehicle);
  const SteadyResponse marched = solver.Solve(excitation, Engine::kTimeIntegration);
  EXPECT_EQ(marched.engine, Engine::kTimeIntegration);
  Multibody multibody(vehicle);
  multibody.SetParameters(vehicle.ParameterValues(), solver.model().preloads);
  EXPECT_EQ(marched.response.channels[0].response, March(multibody, excitation).response.channels[0].response);
}

TEST(SteadyResponse, EndsWhenAskedTo) {
  const Vehicle vehicle = Describe(BilinearCar());
  const Excitation excitation{{2, 5, 8}, {0.01, 0.005, 0.001}, {1}};
  const auto first_only = [](const SteadySolver::Stage& stage) { return stage.done < 1; };
  const SteadyResponse marched = SteadySolver(vehicle).Solve(excitation, Engine::kTimeIntegration, {}, first_only);
  ASSERT_EQ(marched.unanswered.size(), 2u);
  EXPECT_EQ(marched.unanswered[0].frequency_Hz, 5);
  EXPECT_THAT(marched.unanswered[0].why, HasSubstr("[interrupted]"));
  EXPECT_FALSE(std::isnan(std::abs(marched.response.channels[0].response[0])));
  EXPECT_TRUE(std::isnan(std::abs(marched.response.channels[0].response[1])));
  EXPECT_EQ(SteadySolver(vehicle).Solve(excitation, Engine::kFull, {}, first_only).unanswered.size(), 3u);
  // In the middle of a frequency too.
  int asked = 0;
  const auto soon = [&](const SteadySolver::Stage&) { return ++asked < 3; };
  EXPECT_EQ(SteadySolver(vehicle).Solve(excitation, Engine::kTimeIntegration, {}, soon).unanswered.size(), 3u);
  EXPECT_EQ(asked, 3);
}

Vehicle HoppingCar() {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.tyres[0].lifts_off = true;
  Set(vehicle, "c_bump", 300);
  Set(vehicle, "c_rebound", 900);
  return vehicle;
}

TEST(SteadyResponse, RunsNothingFromRestWhereTyresStayWellOnTheGround) {
  const Vehicle vehicle = HoppingCar();
  const auto runs = [&](double amplitude) {
    bool any = false;
    SteadySolver(vehicle).Solve({{2, 25}, {amplitude, amplitude}, {1}}, Engine::kReduced, {},
                                [&](const SteadySolver::Stage& stage) {
                                  any = any || stage.work == std::string("from rest");
                                  return true;
                                });
    return any;
  };
  EXPECT_FALSE(runs(0.001));
  EXPECT_TRUE(runs(0.01));
}

// A wheel that leaves the ground takes every other cycle; the balance, which knows of whole cycles only, does not.
TEST(SteadyResponse, WarnsWhereTheMotionFromRestIsAnother) {
  const Vehicle vehicle = HoppingCar();
  const auto others = [&](Engine engine, double amplitude) {
    return SteadySolver(vehicle).Solve({{25}, {amplitude}, {1}}, engine).other_motions;
  };
  for (const Engine engine : {Engine::kAuto, Engine::kReduced}) {
    const std::vector<OtherMotion> found = others(engine, 0.01);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].frequency_Hz, 25);
    EXPECT_GT(found[0].difference, 0.1);
    EXPECT_THAT(others(engine, 0.001), IsEmpty());
  }
}

// Roll leaves pitch silent, whose rounding is another one in every motion.
TEST(SteadyResponse, HasNothingToWarnOfInWhatIsSilentBySymmetry) {
  const Vehicle car = ShippedVehicle("independent_roadster");
  const Excitation roll{{5.04}, {0.0047}, PostPattern(car, "roll")};
  EXPECT_TRUE(MayHaveSeveralMotions(SteadySolver(car).model(), roll)[0]);
  EXPECT_THAT(SteadySolver(car).Solve(roll, Engine::kReduced).other_motions, IsEmpty());
}

// Where nothing was compared no error is known.
TEST(SteadyResponse, TellsThatItCouldNotEstimate) {
  const Vehicle vehicle = Describe(BilinearCar());
  const SteadyResponse answer = SteadySolver(vehicle).Solve({{5}, {0.005}, {1}}, Engine::kAuto,
                                                            {.error = 1e-15, .most_harmonics = 9, .max_iterations = 1});
  EXPECT_FALSE(answer.kinematics_error);
  EXPECT_THAT(answer.not_estimated, HasSubstr("[nothing-to-compare]"));
  EXPECT_THAT(answer.engine_at, ElementsAre(Engine::kFull));
}

// A tenth of a newton second per metre: heave rings for an hour.
TEST(SteadyResponse, HasNoValueWhereNothingSettles) {
  Vehicle vehicle = Describe(ThesisCar());
  Set(vehicle, "c_bump", 0.1);
  Set(vehicle, "c_rebound", 0.1);
  const SteadyResponse answer = SteadySolver(vehicle).Solve({{3}, {0.001}, {1}}, Engine::kTimeIntegration);
  ASSERT_EQ(answer.unanswered.size(), 1u);
  EXPECT_EQ(answer.unanswered[0].frequency_Hz, 3);
  EXPECT_THAT(answer.unanswered[0].why, AllOf(HasSubstr("60 s"), HasSubstr("[unsteady")));
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
  // Nor by a unit without any other sensor.
  one.channels.back().unit = other.channels.back().unit = "rad/s";
  EXPECT_FALSE(CompareKinematics(one, other).IsVisible());
}

}  // namespace
}  // namespace fourpost::steady_response_test
