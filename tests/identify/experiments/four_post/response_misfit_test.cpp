#include "identify/experiments/four_post/response_misfit.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

namespace fourpost::response_misfit_test {
namespace {

MeasuredRun Measured(std::vector<std::complex<double>> response) {
  MeasuredRun run;
  run.channels.push_back({.sensor = 0, .name = "a_body", .unit = "m/s^2", .response = std::move(response)});
  return run;
}

FrequencyResponse Modelled(std::vector<std::complex<double>> response) {
  FrequencyResponse modelled;
  modelled.channels.push_back({.name = "a_body", .unit = "m/s^2", .response = std::move(response)});
  return modelled;
}

TEST(Misfit, IsTheRootMeanSquareOverFrequenciesAndRecordings) {
  const double quarter = std::numbers::pi / 4;
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(
      {Measured({1, 1}), Measured({2, 2})}, {Modelled({10, 1}), Modelled({2, std::polar(2.0, quarter)})});
  ASSERT_EQ(misfits.size(), 1u);
  EXPECT_EQ(misfits[0].name, "a_body");
  // One of four points is 20 dB off, one of four 45 degrees.
  EXPECT_DOUBLE_EQ(misfits[0].rms_dB, std::sqrt(20.0 * 20.0 / 4));
  EXPECT_DOUBLE_EQ(misfits[0].rms_deg, std::sqrt(45.0 * 45.0 / 4));
}

// Scatter is that of the stated deviations; the linear model is the mean over recordings of one pattern.
TEST(Misfit, StandsBesideScatterAndTheBestLinearModel) {
  std::vector<MeasuredRun> runs = {Measured({1.0, 2.0}), Measured({1.2, 2.0}), Measured({5.0, 5.0})};
  for (MeasuredRun& run : runs) {
    run.excitation = {.frequency_Hz = {1, 2}, .amplitude_m = {0.01, 0.01}, .shape = {1, 1}};
    run.channels[0].radial_sd = {0.03, 0.03};
    run.channels[0].tangential_sd = {0.04, 0.04};
  }
  runs[2].excitation.shape = {1, -1};
  const std::vector<FrequencyResponse> modelled = {Modelled({1, 2}), Modelled({1, 2}), Modelled({5, 5})};
  const ChannelMisfit misfit = ResponseMisfits(runs, modelled)[0];
  const double all = 1 + 4 + 1.44 + 4;
  EXPECT_DOUBLE_EQ(*misfit.scatter_percent, 100 * 6 * 0.0025 / (all + 50));
  EXPECT_NEAR(*misfit.linear_percent, 100 * 0.02 / all, 1e-12);
  EXPECT_EQ(*misfit.Allowed_percent(), *misfit.scatter_percent);
}

TEST(Misfit, TakesTheShortWayRoundTheCircle) {
  const auto misfits = ResponseMisfits({Measured({std::polar(1.0, 3.1)})}, {Modelled({std::polar(1.0, -3.1)})});
  EXPECT_NEAR(misfits[0].rms_deg, (2 * std::numbers::pi - 6.2) * 180 / std::numbers::pi, 1e-12);  // rounding
}

TEST(Misfit, LeavesOutFrequenciesWithoutAnAnswer) {
  const std::complex<double> none(std::nan(""), std::nan(""));
  const auto misfits = ResponseMisfits({Measured({1.0, 2.0})}, {Modelled({10.0, none})});
  EXPECT_DOUBLE_EQ(misfits[0].rms_dB, 20);
  EXPECT_DOUBLE_EQ(misfits[0].nmse_percent, 8100);
}

TEST(Misfit, OfAGroupIsThatOfItsChannels) {
  const std::vector<ChannelMisfit> channels = {{"a_body_front", 3, 30}, {"a_body_rear", 4, 40}, {"s_strut", 100, 100}};
  const ChannelMisfit body = GroupMisfit(channels, "a_body");
  EXPECT_DOUBLE_EQ(body.rms_dB, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(body.rms_deg, std::sqrt(1250));
  EXPECT_DOUBLE_EQ(GroupMisfit(channels, "").rms_dB, std::sqrt((9 + 16 + 1e4) / 3));
}

// A channel next to a node is held against the loud ones of its unit.
TEST(Misfit, OfARecordingIsThatOfItsUnits) {
  MeasuredRun run = Measured({1, 3});
  run.name = "roll";
  run.channels.push_back({.sensor = 1, .name = "a_node", .unit = "m/s^2", .response = {1e-3, 1e-3}});
  run.channels.push_back({.sensor = 2, .name = "s_strut", .unit = "m", .response = {5, 5}});
  FrequencyResponse modelled = Modelled({1, 3});
  modelled.channels.push_back({.name = "a_node", .unit = "m/s^2", .response = {0.1 + 1e-3, 1e-3}});
  modelled.channels.push_back({.name = "s_strut", .unit = "m", .response = {5, 10}});
  const auto misfits = RecordingMisfits({run}, {modelled});
  ASSERT_EQ(misfits.size(), 1U);
  EXPECT_EQ(misfits[0].name, "roll");
  EXPECT_NEAR(misfits[0].nmse_percent, (100 * 0.01 / (10 + 2e-6) + 50) / 2, 1e-12);  // rounding
  const double node_dB = 20 * std::log10(101);
  const double strut_dB = 20 * std::log10(2);
  EXPECT_NEAR(misfits[0].rms_dB, std::sqrt((node_dB * node_dB + strut_dB * strut_dB) / 6), 1e-12);
}

}  // namespace
}  // namespace fourpost::response_misfit_test
