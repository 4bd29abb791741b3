#include "analysis/signals/noise_floor.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::noise_floor_test {
namespace {

/// A sum of sines up to `share` of half the rate, and white noise.
std::vector<double> Signal(double share, double noise) {
  RandomStream draws(1, "signal");
  std::vector<double> signal(8000);
  for (int sine = 1; sine <= 20; ++sine) {
    const double phase = 2 * std::numbers::pi * draws.Uniform();
    for (std::size_t k = 0; k < signal.size(); ++k)
      signal[k] += std::sin(std::numbers::pi * share * sine / 20 * static_cast<double>(k) + phase);
  }
  for (double& value : signal) value += noise * draws.Normal();
  return signal;
}

TEST(NoiseFloor, IsTheDeviationOfWhiteNoiseUnderASignalOfLimitedBand) {
  // Of 2000 independent samples: 1.6 %, three times that.
  EXPECT_NEAR(NoiseFloor(Signal(0.3, 0.01)), 0.01, 0.0005);
  EXPECT_NEAR(NoiseFloor(Signal(0.6, 0.01)), 0.01, 0.0010);
}

TEST(NoiseFloor, IsNothingWithoutNoiseOrInAShortSignal) {
  EXPECT_LT(NoiseFloor(Signal(0.3, 0)), 1e-4);
  EXPECT_EQ(NoiseFloor(std::vector<double>(63, 1.0)), 0);
}

}  // namespace
}  // namespace fourpost::noise_floor_test
