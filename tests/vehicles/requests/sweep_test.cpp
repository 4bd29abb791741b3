#include "vehicles/requests/sweep.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/signals/findings.h"
#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/requests/findings.h"
#include "vehicles/requests/sweep_files.h"
#include "vehicles/response/findings.h"

namespace fourpost::sweep_test {
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
  EXPECT_THAT(diagnostics_, ReportsOption(kModeUnknown, "--mode", {"'heav'", "'heave'", "FL=1"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSharePost, "--mode", {"'XX'", "FL, FR, RL and RR"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kShareMalformed, "--mode", {"FL=a"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kFrequencyRangeMalformed, "--frequencies", {"'1:2'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionQuantity, "--amplitude", {"'5'", "length", "5 mm"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionNotPositive, "--velocity", {"'-1m/s'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionQuantity, "--acceleration", {"'1m/s'", "acceleration"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionSensor, "--channels", {"'a_nothing'"}));
}

// Generated vehicles call their posts front_post_left and the like.
TEST_F(SweepReading, TakesAPostByAPlaceThatIsItsAlone) {
  vehicle_.posts[0].name = "front_post_left";
  const auto request = Read({.modes = {"FL=1,RR=-0.5"}});
  ASSERT_TRUE(request) << diagnostics_.Format();
  EXPECT_THAT(request->sweeps[0].excitation.shape, ElementsAre(1, 0, 0, -0.5));
  EXPECT_FALSE(Read({.modes = {"front=1"}}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSharePost, "--mode", {"'front'"}));
}

TEST_F(SweepReading, TakesEachPostOnce) {
  EXPECT_FALSE(Read({.modes = {"FL=1,RL=1,FL=-1"}}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSharePostTwice, "--mode", {"'FL'"}));
  EXPECT_EQ(diagnostics_.items().size(), 1u);
}

TEST_F(SweepReading, NeedsAReferencePost) {
  EXPECT_FALSE(Read({.modes = {vehicle_.posts[0].name + "=0.3"}}));
  EXPECT_THAT(diagnostics_, ReportsOption(kShareNoReference, "--mode"));
}

TEST_F(SweepReading, NeedsPostsAndSensors) {
  vehicle_.posts.clear();
  vehicle_.sensors.clear();
  EXPECT_FALSE(Read({}));
  EXPECT_THAT(diagnostics_, Reports(kPostNone, 0));
  EXPECT_THAT(diagnostics_, Reports(kSensorNone, 0));
}

TEST_F(SweepReading, RefusesMoreThanThePostsCan) {
  vehicle_.posts[2].stroke = 0.05;
  EXPECT_FALSE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "30mm"}}));
  EXPECT_THAT(diagnostics_, Reports(kStrokeExceeded, {"25 mm", "heave at 1 Hz", "30 mm"}));
}

TEST_F(SweepReading, WarnsAboveWhatRigidBodiesKnow) {
  EXPECT_TRUE(Read({}));
  EXPECT_EQ(diagnostics_.Format(), "");
  EXPECT_TRUE(Read({.frequencies = "1Hz:50Hz:5"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kBodiesBend, "--frequencies", {"30 Hz"}));
}

TEST_F(SweepReading, TakesTheUsualStrokeOfPostsThatTellNone) {
  EXPECT_FALSE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "80mm"}}));
  EXPECT_THAT(diagnostics_, Reports(kUsualStrokeExceeded, {"75 mm", "heave at 1 Hz", "80 mm"}));
  EXPECT_TRUE(Read({.frequencies = "1Hz,2Hz", .limits = {.amplitude = "80mm"}, .stroke = "160mm"}));
}

TEST_F(SweepReading, WarnsWhereUsualLimitsNoLongerCount) {
  EXPECT_TRUE(Read({.frequencies = "1Hz:30Hz:5", .limits = {.amplitude = "3mm", .acceleration = "6m/s^2"}}));
  EXPECT_EQ(diagnostics_.Format(), "");
  EXPECT_TRUE(Read({.frequencies = "1Hz:30Hz:5", .limits = {.amplitude = "3mm"}}));
  // 3 mm at 30 Hz.
  EXPECT_THAT(diagnostics_, ReportsOption(kLimitOpen, "--acceleration", {"6 m/s^2", "107 m/s^2"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kLimitOpen, "--velocity", {"0.15 m/s", "0.565 m/s"}));
}

/// Two frequencies, from above, of two sensors.
SweptResponse Example() {
  SteadyResponse answer{.response = {.frequency_Hz = {2, 1}, .amplitude_m = {0.1, 0.2}},
                        .engine_at = {Engine::kTimeIntegration, Engine::kReduced}};
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
  EXPECT_EQ(swept.answer.engine_at[1], Engine::kTimeIntegration);
}

TEST(SweptResponse, IsATableThatLeavesBlankWhatHasNoAnswer) {
  EXPECT_EQ(SweepCsv({Example()}),
            "mode,channel,unit,frequency_Hz,post_amplitude_m,gain,phase_deg,mean,second_harmonic,engine\n"
            "heave,two,m,1,0.2,2,90,0.5,0.25,reduced\n"
            "heave,two,m,2,0.1,,,,,time\n");
}

TEST(SweptResponse, IsAPictureWithoutWhatIsNotANumber) {
  const std::string svg = SweepSvg("car", {Example()});
  EXPECT_THAT(svg, HasSubstr("heave: gain [dB]"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace fourpost::sweep_test
