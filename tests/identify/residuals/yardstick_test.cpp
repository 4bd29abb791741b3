#include "identify/residuals/yardstick.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"
#include "identify/residuals/history_table.h"

namespace fourpost::yardstick_test {
namespace {

using Eigen::Index;

constexpr double kRate_Hz = 500;
/// Of its amplitude.
constexpr double kNoise = 0.05;

/// A mass on a spring and a damper, 2 Hz and 0.2, on a post that moves by noise of second order; with noise of its own.
YardstickRecord Station(const std::string& name, std::uint64_t motion, std::uint64_t noise, int posts = 1) {
  constexpr Index kSamples = 30000;
  RandomStream draws(motion, "post");
  YardstickRecord record{.name = name, .rate_Hz = kRate_Hz, .inputs = Eigen::MatrixXd(kSamples, posts)};
  Eigen::VectorXd mass(kSamples);
  double post = 0, low = 0, speed = 0, height = 0;
  for (Index k = 0; k < kSamples; ++k) {
    constexpr double kStep = 1 / kRate_Hz;
    constexpr double kOmega = 2 * 3.141592653589793 * 2;
    low += 0.05 * (draws.Normal() - low);
    post += 0.05 * (low - post);
    speed += kStep * (kOmega * kOmega * (post - height) - 0.4 * kOmega * speed);
    height += kStep * speed;
    record.inputs.row(k).setConstant(post);
    mass[k] = height;
  }
  RandomStream errors(noise, "noise");
  const double sd = kNoise * std::sqrt((mass.array() - mass.mean()).square().mean());
  for (double& value : mass) value += sd * errors.Normal();
  record.channels = {{"mass", mass}};
  return record;
}

HistoryMisfit Judged(const std::vector<YardstickRecord>& fitted, const YardstickRecord& judged, double nmse_percent) {
  std::vector<HistoryMisfit> misfits = {{.recording = judged.name, .name = "mass", .nmse_percent = nmse_percent}};
  AddYardsticks(fitted, {judged}, misfits);
  return misfits.front();
}

// What a linear model of another recording leaves is the noise, 100 kNoise^2 %.
TEST(Yardstick, LeavesNoiseToTheLinearModelAndToRepeats) {
  const YardstickRecord first = Station("first", 1, 1);
  const HistoryMisfit misfit = Judged({first}, Station("other", 2, 2), 1);
  const double floor = 100 * kNoise * kNoise;
  ASSERT_TRUE(misfit.yardstick.nmse_percent);
  EXPECT_NEAR(*misfit.yardstick.nmse_percent, floor, 0.1 * floor);
  EXPECT_LE(*misfit.yardstick.one_step_nmse_percent, 1.1 * floor);
  EXPECT_FALSE(misfit.yardstick.repeat_nmse_percent);
  const HistoryMisfit repeated = Judged({first}, Station("again", 1, 3), 1);
  // 30000 independent differences: 1 %, four times.
  EXPECT_NEAR(*repeated.yardstick.repeat_nmse_percent, floor, 0.04 * floor);
  EXPECT_NE(YardstickTable({repeated}).find("repeats, %"), std::string::npos);
}

// A load cell whose zero moves by its own deviation between two runs of a bench: half of the squared difference.
TEST(Yardstick, CountsTheMeanOfRepeatsWhereItIsCompared) {
  YardstickRecord first = Station("first", 1, 1);
  YardstickRecord again = Station("again", 1, 3);
  Eigen::VectorXd& values = again.channels.front().values;
  values.array() += std::sqrt((values.array() - values.mean()).square().mean());
  const double floor = 100 * kNoise * kNoise;
  EXPECT_NEAR(*Judged({first}, again, 1).yardstick.repeat_nmse_percent, floor, 0.04 * floor);
  first.has_means = again.has_means = true;
  EXPECT_NEAR(*Judged({first}, again, 1).yardstick.repeat_nmse_percent, 50 + floor, 1);
}

// The other way round: four times its variance are no measure of what the data allow.
TEST(Yardstick, SaysNothingByALinearModelThatIsWorseThanAConstant) {
  YardstickRecord turned = Station("turned", 2, 2);
  turned.channels.front().values *= -1;
  const HistoryMisfit misfit = Judged({Station("first", 1, 1)}, turned, 1);
  EXPECT_FALSE(misfit.yardstick.nmse_percent);
  EXPECT_FALSE(misfit.yardstick.Allowed_percent());
}

// Four posts in heave are one input.
TEST(Yardstick, TakesPostsThatMoveAlikeAsOne) {
  const YardstickRecord first = Station("first", 1, 1, 4);
  const HistoryMisfit misfit = Judged({first}, first, 1);
  ASSERT_TRUE(misfit.yardstick.nmse_percent);
  EXPECT_NEAR(*misfit.yardstick.nmse_percent, 100 * kNoise * kNoise, 0.03);
}

TEST(Yardstick, SaysNothingWithoutAFittedRecordingOfTheRate) {
  YardstickRecord slower = Station("slower", 2, 2);
  slower.rate_Hz = 250;
  const HistoryMisfit misfit = Judged({Station("first", 1, 1)}, slower, 1);
  EXPECT_FALSE(misfit.yardstick.Allowed_percent());
  EXPECT_EQ(YardstickTable({misfit}), "");
}

}  // namespace
}  // namespace fourpost::yardstick_test
