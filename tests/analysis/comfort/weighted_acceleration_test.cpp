#include "analysis/comfort/weighted_acceleration.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::weighted_acceleration_test {
namespace {

using std::numbers::pi;

constexpr double kRate = 1000;

std::vector<double> Sampled(double duration, const std::function<double(double)>& signal) {
  std::vector<double> samples;
  for (int k = 0; k <= std::lround(duration * kRate); ++k) samples.push_back(signal(k / kRate));
  return samples;
}

// Whole periods: mean squares 1/2, fourth powers 3/8. The running mean square over tau = 1 s is
// 1/2 (1 - cos(2 w t - w tau) sin(w tau) / (w tau)).
TEST(WeightedAcceleration, OfASineHasClosedForms) {
  constexpr double kAmplitude = 2.5;
  for (const double f : {1.25, 4.5, 10.0, 7.3}) {
    const double w = 2 * pi * f;
    const WeightedAcceleration of =
        MeasuresOf(Sampled(20, [&](double t) { return kAmplitude * std::sin(w * t); }), kRate);
    EXPECT_NEAR(of.duration_s, 20, 1e-12);
    EXPECT_NEAR(of.rms, kAmplitude * std::sqrt(0.5), 1e-6 * of.rms) << f;
    EXPECT_NEAR(of.vdv, kAmplitude * std::pow(0.375 * 20, 0.25), 1e-6 * of.vdv) << f;
    EXPECT_NEAR(of.mtvv, kAmplitude * std::sqrt(0.5 * (1 + std::abs(std::sin(w)) / w)), 1e-6 * of.mtvv) << f;
    EXPECT_TRUE(of.RmsSuffices());
  }
}

/// sin^2 pulse from 3 s on, shorter than a second: mean squares 3/8, fourth powers 35/128 of it.
TEST(WeightedAcceleration, OfAPulseHasClosedForms) {
  constexpr double kLength = 0.4;
  const auto pulse = [&](double t) {
    return t < 3 || t > 3 + kLength ? 0 : 3 * std::pow(std::sin(pi * (t - 3) / kLength), 2);
  };
  const WeightedAcceleration of = MeasuresOf(Sampled(10, pulse), kRate);
  EXPECT_NEAR(of.rms, 3 * std::sqrt(0.375 * kLength / 10), 1e-6 * of.rms);
  EXPECT_NEAR(of.mtvv, 3 * std::sqrt(0.375 * kLength), 1e-6 * of.mtvv);
  EXPECT_NEAR(of.vdv, 3 * std::pow(35.0 / 128 * kLength, 0.25), 1e-6 * of.vdv);
  EXPECT_GT(of.MtvvRatio(), WeightedAcceleration::kMostMtvv);
  EXPECT_GT(of.VdvRatio(), WeightedAcceleration::kMostVdv);
  EXPECT_FALSE(of.RmsSuffices());
}

// A sine burst of 16 periods under sin^2(pi t / L), two seconds long: the running window holds its middle half. With
// s = sin^2, s^2 sin^2 = s^2 / 2 - s^2 cos(2 w t) / 2, and over the middle the second part vanishes for whole periods.
TEST(WeightedAcceleration, OfABurstHasClosedForms) {
  constexpr double kLength = 2;
  const auto burst = [&](double t) {
    return t > kLength ? 0 : std::pow(std::sin(pi * t / kLength), 2) * std::sin(2 * pi * 8 * t);
  };
  const WeightedAcceleration of = MeasuresOf(Sampled(6, burst), kRate);
  EXPECT_NEAR(of.rms, std::sqrt(0.5 * 0.375 * kLength / 6), 1e-6 * of.rms);
  EXPECT_NEAR(of.vdv, std::pow(0.375 * 35.0 / 128 * kLength, 0.25), 1e-6 * of.vdv);
  // By Simpson's rule in steps of 1/8 ms, about the burst's middle.
  double energy = 0;
  constexpr int kSteps = 8000;
  for (int k = 0; k <= kSteps; ++k) {
    const double a = burst(0.5 + static_cast<double>(k) / kSteps);
    energy += (k == 0 || k == kSteps ? 1 : k % 2 == 1 ? 4 : 2) * a * a / (3.0 * kSteps);
  }
  EXPECT_NEAR(of.mtvv, std::sqrt(energy), 1e-6 * of.mtvv);
}

// The dose of a normal distribution: 40000 values, whose fourth power's mean has the deviation sqrt(96 / 40000) / 3.
TEST(WeightedAcceleration, OfRandomHasTheDoseOfItsRms) {
  RandomStream draws(7, "dose");
  std::vector<double> samples;
  for (int k = 0; k < 40000; ++k) {
    samples.push_back(std::sqrt(-2 * std::log(1 - draws.Uniform())) * std::cos(2 * pi * draws.Uniform()));
  }
  double fourth = 0;
  double square = 0;
  for (const double a : samples) {
    square += a * a / 40000;
    fourth += a * a * a * a / 40000;
  }
  EXPECT_NEAR(std::pow(fourth * 60, 0.25), VibrationDoseOfRandom(std::sqrt(square), 60),
              4 * 0.25 * std::sqrt(96.0 / 40000) / 3 * VibrationDoseOfRandom(1, 60));
}

TEST(WeightedAcceleration, OfRestIsZero) {
  const WeightedAcceleration of = MeasuresOf(std::vector<double>(100, 0.0), kRate);
  EXPECT_EQ(of.rms, 0);
  EXPECT_EQ(of.mtvv, 0);
  EXPECT_EQ(of.vdv, 0);
  EXPECT_TRUE(of.RmsSuffices());
}

TEST(WeightedAcceleration, RefusesWhatIsNoSignal) {
  EXPECT_THROW(MeasuresOf(std::vector<double>{1}, kRate), std::invalid_argument);
  EXPECT_THROW(MeasuresOf(std::vector<double>{1, 2}, -1), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::weighted_acceleration_test
