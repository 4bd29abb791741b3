#include "analysis/signals/sensor_noise.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/low_pass.h"
#include "analysis/signals/random_stream.h"

namespace fourpost::sensor_noise_test {
namespace {

constexpr double kRate = 500;

std::vector<double> Normal(std::size_t count, double sd) {
  RandomStream stream(3, "sensor noise", 0);
  std::vector<double> noise;
  for (std::size_t k = 0; k < count; ++k) noise.push_back(sd * stream.Normal());
  return noise;
}

TEST(SensorNoise, WhiteNormalNoiseIsThatWithAnOffsetAndADrift) {
  std::vector<double> signal = Normal(5000, 0.2);
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] += 7 + 1e-3 * static_cast<double>(k);
  const SensorNoise noise = SensorNoiseOf(signal, kRate);
  // One over the root of 2 N is 1 %; four of them.
  EXPECT_NEAR(noise.sd, 0.2, 0.04 * 0.2);
  EXPECT_TRUE(noise.is_white);
  EXPECT_TRUE(noise.is_normal);
  EXPECT_FALSE(noise.line_Hz);
  EXPECT_GT(noise.below_Hz, 220);
}

TEST(SensorNoise, FilteredNoiseIsNotWhite) {
  std::vector<double> signal = Normal(10000, 1);
  LowPass(4, 30, kRate).Apply(signal);
  const SensorNoise noise = SensorNoiseOf(signal, kRate);
  EXPECT_FALSE(noise.is_white);
  EXPECT_TRUE(noise.is_normal);
  // A filter of fourth order passes 1.026 times its cut-off of white noise, nearly all of it below 1.2 times.
  EXPECT_NEAR(noise.below_Hz, 30, 5);
}

TEST(SensorNoise, MainsHumIsALine) {
  std::vector<double> signal = Normal(5000, 0.1);
  for (std::size_t k = 0; k < signal.size(); ++k)
    signal[k] += 0.2 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(k) / kRate);
  const SensorNoise noise = SensorNoiseOf(signal, kRate);
  ASSERT_TRUE(noise.line_Hz);
  EXPECT_NEAR(*noise.line_Hz, 50, kRate / 1024);
}

TEST(SensorNoise, SpikesAreNotNormal) {
  std::vector<double> signal = Normal(5000, 0.1);
  for (std::size_t k = 100; k < signal.size(); k += 250) signal[k] += 1;
  EXPECT_FALSE(SensorNoiseOf(signal, kRate).is_normal);
  EXPECT_THROW(SensorNoiseOf(std::vector<double>(63), kRate), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::sensor_noise_test
