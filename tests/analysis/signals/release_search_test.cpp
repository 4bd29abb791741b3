#include "analysis/signals/release_search.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::release_search_test {
namespace {

constexpr double kRate_Hz = 1000;
constexpr double kNoise = 0.01;

using Law = std::function<double(double t_s)>;

/// With white noise.
std::vector<double> Sampled(double duration_s, const Law& law, unsigned seed = 1) {
  RandomStream random(seed, "noise");
  std::vector<double> values;
  for (int k = 0; k < static_cast<int>(duration_s * kRate_Hz); ++k)
    values.push_back(law(k / kRate_Hz) + kNoise * random.Normal());
  return values;
}

/// A mass on a spring that is held 10 above its rest until 1.5 s.
double Height(double t_s) {
  const double after_s = t_s - 1.5;
  return after_s < 0 ? 10 : 10 * std::exp(-4 * after_s) * std::cos(9 * after_s);
}

/// Its acceleration, in another unit; held, it stands.
double Acceleration(double t_s) {
  const double after_s = t_s - 1.5;
  return after_s < 0 ? 0 : -std::exp(-4 * after_s) * std::cos(9 * after_s + 0.8);
}

std::vector<ReleaseSamples> Found(const std::vector<std::vector<double>>& signals) {
  const std::vector<std::span<const double>> views(signals.begin(), signals.end());
  return ReleasesOf(views, kRate_Hz);
}

TEST(ReleaseSearch, FindsTheFirstSampleThatLeavesItsRest) {
  const std::vector<ReleaseSamples> found = Found({Sampled(6, Height), Sampled(6, Acceleration, 2)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].rest_from, 0u);
  EXPECT_EQ(found[0].let_go, 1500u);
  // What is left of the height, 10 e^-4t, is that of the noise from 1.7 s on; its swing takes 0.7 s.
  EXPECT_NEAR(static_cast<double>(found[0].rest), 3200, 350);
  EXPECT_EQ(found[0].end, 6000u);
}

TEST(ReleaseSearch, FindsEachOfSeveralAndNoLift) {
  const auto twice = [](double t_s) {
    // Lifted by a hoist in 3 s, and let go again.
    const double lift = std::clamp((t_s - 6) / 3, 0.0, 1.0);
    return t_s < 6 ? Height(t_s) : t_s < 10 ? 20 * lift * lift * (3 - 2 * lift) : 2 * Height(t_s - 8.5);
  };
  const auto acceleration = [](double t_s) { return t_s < 10 ? Acceleration(t_s) : 2 * Acceleration(t_s - 8.5); };
  const std::vector<std::vector<double>> signals = {Sampled(15, twice), Sampled(15, acceleration, 2)};
  const std::vector<ReleaseSamples> found = Found(signals);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].let_go, 1500u);
  EXPECT_EQ(found[1].let_go, 10000u);
  // Means of hundreds of samples, and what is left of the motion at rest.
  EXPECT_NEAR(StepOf(signals[0], found[0]), 10, kNoise);
  EXPECT_NEAR(StepOf(signals[0], found[1]), 20, kNoise);
  EXPECT_EQ(StepOf(signals[1], found[0]), 0);
}

TEST(ReleaseSearch, WhatFadesInAndOutIsNone) {
  const auto burst = [](double t_s) {
    return t_s > 1.5 && t_s < 4 ? std::pow(std::sin(1.2566 * (t_s - 1.5)), 2) * std::sin(40 * t_s) : 0;
  };
  EXPECT_TRUE(Found({Sampled(6, burst)}).empty());
  EXPECT_TRUE(Found({Sampled(6, [](double) { return 0; })}).empty());
  EXPECT_TRUE(Found({}).empty());
}

TEST(ReleaseSearch, AStepIsNoDriftAndADriftBesideItIs) {
  const std::vector<double> steady = Sampled(8.5, Height);
  const std::vector<double> drifting = Sampled(
      8.5, [](double t_s) { return Height(t_s) + 0.3 * t_s / 8.5; }, 3);
  const std::vector<ReleaseSamples> found = Found({steady, Sampled(8.5, Acceleration, 2)});
  ASSERT_EQ(found.size(), 1u);
  // Six deviations of a slope through n samples at rest: noise sqrt(12 / n^3), times all samples; some n = 4500.
  const double certain = 6 * kNoise * std::sqrt(12 / std::pow(4500, 3)) * 8500;
  EXPECT_NEAR(DriftAtRest(steady, found), 0, certain);
  EXPECT_NEAR(DriftAtRest(drifting, found), 0.3, certain);
}

}  // namespace
}  // namespace fourpost::release_search_test
