#include "identify/experiments/time_history/post_noise.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/history_simulation.h"
#include "tests/identify/recorded_station.h"

namespace fourpost::post_noise_test {
namespace {

using Eigen::Index;

constexpr double kRate_Hz = 200;
constexpr Index kSamples = 8000;
constexpr double kStep_s = 0.25 / kRate_Hz;
constexpr double kNoise = 40e-6;  // m
constexpr double kCorrelation = 0.9;

/// From sample to sample so much of each is left.
std::vector<double> Correlated(std::uint64_t seed, double correlation, double deviation) {
  RandomStream draws(seed, "test");
  std::vector<double> values = {draws.Normal()};
  for (Index k = 1; k < kSamples; ++k)
    values.push_back(correlation * values.back() + std::sqrt(1 - correlation * correlation) * draws.Normal());
  for (double& value : values) value *= deviation;
  return values;
}

/// Of that noise [m^2/Hz], one-sided, mean over a band.
double Density(double from_Hz, double to_Hz) {
  double sum = 0;
  constexpr int kPoints = 100;
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2 * std::numbers::pi * (from_Hz + (to_Hz - from_Hz) * (i + 0.5) / kPoints) / kRate_Hz;
    sum += 1 / std::norm(1.0 - kCorrelation * std::polar(1.0, -turn));
  }
  return sum / kPoints * kNoise * kNoise * (1 - kCorrelation * kCorrelation) * 2 / kRate_Hz;
}

class PostNoiseTest : public testing::Test {
 protected:
  /// A random motion of 8 mm, mostly below 5 Hz.
  MeasuredHistory Moved() const {
    MeasuredHistory history{.name = "random", .rate_Hz = kRate_Hz};
    std::vector<double> heights = Correlated(3, 0.9, 0.03);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t k = 1; k < heights.size(); ++k) heights[k] = 0.9 * heights[k - 1] + 0.1 * heights[k];
    history.heights = {heights};
    history.post_noise_sd = {0};
    history.post_noise_is_stated = {0};
    history.count = kSamples;
    Follow(history);
    for (std::size_t s = 0; s < vehicle_.sensors.size(); ++s)
      history.signals.push_back({.sensor = s, .name = vehicle_.sensors[s].name});
    return history;
  }

  static void Follow(MeasuredHistory& history) {
    history.posts = FollowHeights(history.heights, 0, 1 / kRate_Hz, nullptr);
  }

  /// What the vehicle's sensors read, with white noise of a per cent.
  static void Measure(const Vehicle& vehicle, MeasuredHistory& history) {
    const Eigen::MatrixXd readings = HistorySimulation(history, kStep_s).Run(ModelOf(vehicle));
    for (std::size_t s = 0; s < history.signals.size(); ++s) {
      RandomStream draws(50 + s, "test");
      Eigen::VectorXd values = readings.col(static_cast<Index>(s));
      const double sd = 0.01 * std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
      for (double& value : values) value += sd * draws.Normal();
      history.signals[s].values = values;
    }
  }

  static void AddNoise(MeasuredHistory& history) {
    const std::vector<double> noise = Correlated(9, kCorrelation, kNoise);
    for (std::size_t k = 0; k < noise.size(); ++k) history.heights[0][k] += noise[k];
    Follow(history);
  }

  static CondensedModel ModelOf(const Vehicle& vehicle) {
    return CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  }

  PostNoise Found(const MeasuredHistory& history) const {
    const CondensedModel model = ModelOf(vehicle_);
    return PostNoiseOf(history, model, HistorySimulation(history, kStep_s).Run(model), kStep_s);
  }

  Vehicle vehicle_ = ShippedVehicle("single_wheel_station");
};

// Independent of the posts' own spectrum, in which nothing of this noise shows beside the motion.
TEST_F(PostNoiseTest, OfAnyColourShowsInWhatChannelsShare) {
  MeasuredHistory history = Moved();
  Measure(vehicle_, history);
  AddNoise(history);
  const PostNoise found = Found(history);
  for (std::size_t b = 1; b + 1 < found.ends_Hz.size(); ++b) {
    SCOPED_TRACE(found.ends_Hz[b]);
    // Some 20 independent segments; within an octave the spectrum falls to a third, and where it counts is the
    // vehicle's.
    EXPECT_NEAR(found.density[0][b] / Density(found.ends_Hz[b - 1], found.ends_Hz[b]), 1, 0.35);
  }
}

TEST_F(PostNoiseTest, IsNoneOfAnExactRecording) {
  MeasuredHistory history = Moved();
  Measure(vehicle_, history);
  const PostNoise found = Found(history);
  for (std::size_t b = 0; b < found.ends_Hz.size(); ++b)
    EXPECT_LT(found.density[0][b], 0.02 * Density(0.5 * found.ends_Hz[b], found.ends_Hz[b])) << found.ends_Hz[b];
}

TEST_F(PostNoiseTest, ThatIsStatedIsWhiteAndOfThatSize) {
  MeasuredHistory history = Moved();
  Measure(vehicle_, history);
  AddNoise(history);
  history.post_noise_sd = {1e-5};
  history.post_noise_is_stated = {1};
  const PostNoise found = Found(history);
  for (const double density : found.density[0]) EXPECT_NEAR(density, 1e-10 * 2 / kRate_Hz, 1e-20);
}

// Friction that the model lacks is seen by all channels, too, but does not pass through the tyre first.
TEST_F(PostNoiseTest, IsNotWhatTheModelLacks) {
  MeasuredHistory history = Moved();
  Vehicle rubbing = vehicle_;
  rubbing.dampers[0].law.friction = DashpotDescription::Friction{.force = {60}, .speed = {0.005}};
  Measure(rubbing, history);
  const PostNoise found = Found(history);
  for (const double density : found.density[0]) EXPECT_EQ(density, 0);
}

// Without a second channel the empty part of the post's spectrum is all there is.
TEST_F(PostNoiseTest, OfOneChannelIsThatOfThePost) {
  MeasuredHistory history = Moved();
  Measure(vehicle_, history);
  AddNoise(history);
  history.signals.resize(1);
  EXPECT_FALSE(Found(history).IsAny());
  history.post_noise_sd = {1e-5};
  const PostNoise found = Found(history);
  EXPECT_TRUE(found.IsAny());
  for (const double density : found.density[0]) EXPECT_NEAR(density, 1e-10 * 2 / kRate_Hz, 1e-20);
}

TEST_F(PostNoiseTest, IsAddedWithItsSpectrum) {
  const MeasuredHistory history = Moved();
  const PostNoise noise = {.ends_Hz = {25, 50, 100}, .density = {{4e-12, 0, 1e-12}}};
  double squares = 0;
  const MeasuredHistory noisy = WithPostNoise(history, noise, 1, -1);
  for (std::size_t k = 0; k < noisy.heights[0].size(); ++k)
    squares += std::pow(noisy.heights[0][k] - history.heights[0][k], 2);
  // 25 Hz of 4e-12 and 50 Hz of 1e-12; of some 6000 independent samples, 2 %, twice.
  EXPECT_NEAR(squares / kSamples / 150e-12, 1, 0.05);
}

}  // namespace
}  // namespace fourpost::post_noise_test
