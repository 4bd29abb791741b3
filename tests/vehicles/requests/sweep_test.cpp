#include "vehicles/requests/sweep.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/requests/sweep_files.h"

namespace fourpost {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SweepReading : public testing::Test {
 protected:
  std::optional<SweepRequest> Read(const SweepText& text) { return ReadSweep(text, vehicle_, diagnostics_); }

  Vehicle vehicle_ = ShippedVehicle("landrover110_model3");
  Diagnostics diagnostics_;
};

TEST_F(SweepReading, HasTheMotionOfTheShippedRigByDefault) {
  const auto request = Read({});
  ASSERT_TRUE(request);
  ASSERT_EQ(request->sweeps.size(), 1u);
  const Excitation& heave = request->sweeps[0].excitation;
  EXPECT_THAT(heave.shape, ElementsAre(1, 1, 1, 1));
  EXPECT_EQ(heave.frequency_Hz.size(), 40u);
  EXPECT_EQ(heave.amplitude_m.front(), 0.012);
  EXPECT_NEAR(heave.amplitude_m.back() * std::pow(2 * std::numbers::pi * 30, 2), 6, 1e-12);  // rounding
  EXPECT_EQ(request->channels.size(), vehicle_.sensors.size());
}

TEST_F(SweepReading, TakesPatternsAndShares) {
  const std::string shares = vehicle_.posts[1].name + "=-1," + vehicle_.posts[0].name + "=0.5";
  const auto request =
      Read({.modes = {"roll", shares, "roll"}, .frequencies = "1Hz,2Hz", .limits = {.amplitude = "5mm"}});
  ASSERT_TRUE(request) << diagnostics_.Format();
  ASSERT_EQ(request->sweeps.size(), 2u);
  EXPECT_THAT(request->sweeps[1].excitation.shape, ElementsAre(0.5, -1, 0, 0));
  EXPECT_THAT(request->sweeps[1].excitation.amplitude_m, ElementsAre(0.005, 0.005));
}

TEST_F(SweepReading, TakesTheFrequenciesOfAFallingSweepFromAbove) {
  const auto request = Read({.frequencies = "1Hz,2Hz", .limits = {.velocity = "0.1m/s"}, .falling = true});
  ASSERT_TRUE(request);
  EXPECT_THAT(request->sweeps[0].excitation.frequency_Hz, ElementsAre(2, 1));
  EXPECT_LT(request->sweeps[0].excitation.amplitude_m[0], request->sweeps[0].excitation.amplitude_m[1]);
}

TEST_F(SweepReading, TellsAllFaultsAtOnce) {
  EXPECT_FALSE(Read({.modes = {"heav", "XX=1", vehicle_.posts[0].name + "=a", vehicle_.posts[0].name + "=0.3"},
                     .frequencies = "1:2",
                     .limits = {.amplitude = "5", .velocity = "-1m/s", .acceleration = "1m/s"},
                     .channels = {"a_nothing"}}));
  const std::string faults = diagnostics_.Format();
  for (const char* part :
       {"--mode: error: no pattern of posts is called 'heav', did you mean 'heave'?; or tell the share of each post",
        "the vehicle has no post 'XX'; it has FL, FR, RL and RR", "is no share of a post",
        "--frequencies: error: ", "--amplitude: error: '5' is no length: write a number with its unit, such as 5 mm",
        "--velocity: error: '-1m/s' must be above zero", "--acceleration: error: '1m/s' is no acceleration",
        "--channels: error: the vehicle has no sensor 'a_nothing'"})
    EXPECT_THAT(faults, HasSubstr(part));
}

TEST_F(SweepReading, TakesEachPostOnce) {
  EXPECT_FALSE(Read({.modes = {"FL=1,RL=1,FL=-1"}}));
  EXPECT_EQ(diagnostics_.Format(), "--mode: error: post 'FL' is named twice");
}

TEST_F(SweepReading, NeedsAReferencePost) {
  EXPECT_FALSE(Read({.modes = {vehicle_.posts[0].name + "=0.3"}}));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("one post is the reference, whose share is 1 or -1"));
}

TEST_F(SweepReading, NeedsPostsAndSensors) {
  vehicle_.posts.clear();
  vehicle_.sensors.clear();
  EXPECT_FALSE(Read({}));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("the vehicle has no fp:post to move"));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("the vehicle has no fp:sensor"));
}

TEST_F(SweepReading, RefusesMoreThanThePostsCan) {
  vehicle_.posts[2].stroke = 0.05;
  EXPECT_FALSE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "30mm"}}));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("reaches 25 mm up and down, and heave at 1 Hz asks 30 mm of it"));
}

TEST_F(SweepReading, WarnsAboveWhatRigidBodiesKnow) {
  EXPECT_TRUE(Read({}));
  EXPECT_EQ(diagnostics_.Format(), "");
  EXPECT_TRUE(Read({.frequencies = "1Hz:50Hz:5"}));
  EXPECT_THAT(diagnostics_.Format(),
              HasSubstr("--frequencies: warning: above 30 Hz the bodies of a road vehicle bend"));
}

TEST_F(SweepReading, TakesTheUsualStrokeOfPostsThatTellNone) {
  EXPECT_FALSE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "80mm"}}));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("reaches 75 mm up and down, and heave at 1 Hz asks 80 mm of it"));
  EXPECT_TRUE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "80mm"}, .stroke = "160mm"}));
}

TEST_F(SweepReading, WarnsWhereUsualLimitsNoLongerCount) {
  EXPECT_TRUE(Read({.frequencies = "1Hz:30Hz:5", .limits = {.amplitude = "3mm", .acceleration = "6m/s^2"}}));
  EXPECT_EQ(diagnostics_.Format(), "");
  EXPECT_TRUE(Read({.frequencies = "1Hz:30Hz:5", .limits = {.amplitude = "3mm"}}));
  // 3 mm at 30 Hz.
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("usual 6 m/s^2 does not count: the post reaches 107 m/s^2"));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("usual 0.15 m/s does not count: the post reaches 0.565 m/s"));
}

/// Two frequencies, from above, of two sensors.
SweptResponse Example() {
  SteadyResponse answer{.response = {.frequency_Hz = {2, 1}, .amplitude_m = {0.1, 0.2}},
                        .engine_at = {Engine::kMarch, Engine::kReduced}};
  for (const char* name : {"one", "two"})
    answer.response.channels.push_back({.name = name,
                                        .unit = "m",
                                        .response = {std::nan(""), {0, 2}},
                                        .mean = {std::nan(""), 0.5},
                                        .second_harmonic = {std::nan(""), 0.25}});
  return Sorted({"heave", {{2, 1}, {0.1, 0.2}, {1}}}, answer, {1});
}

TEST(SweptResponse, IsByRisingFrequencyAndOfTheChannelsAskedFor) {
  const SweptResponse swept = Example();
  EXPECT_THAT(swept.excitation.frequency_Hz, ElementsAre(1, 2));
  EXPECT_THAT(swept.answer.response.amplitude_m, ElementsAre(0.2, 0.1));
  ASSERT_EQ(swept.answer.response.channels.size(), 1u);
  EXPECT_EQ(swept.answer.response.channels[0].name, "two");
  EXPECT_EQ(swept.answer.engine_at[1], Engine::kMarch);
}

TEST(SweptResponse, IsATableThatLeavesBlankWhatHasNoAnswer) {
  EXPECT_EQ(SweepCsv({Example()}),
            "mode,channel,unit,frequency_Hz,post_amplitude_m,gain,phase_deg,mean,second_harmonic,engine\n"
            "heave,two,m,1,0.2,2,90,0.5,0.25,reduced\n"
            "heave,two,m,2,0.1,,,,,march\n");
}

TEST(SweptResponse, IsAPictureWithoutWhatIsNotANumber) {
  const std::string svg = SweepSvg("car", {Example()});
  EXPECT_THAT(svg, HasSubstr("heave: gain [dB]"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace fourpost
