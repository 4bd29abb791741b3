#include "analysis/signals/signal_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace fourpost::signal_levels_test {
namespace {

/// The smallest difference by all values in order.
double LeastDifference(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double least = values.back() - values.front();
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] > values[k - 1]) least = std::min(least, values[k] - values[k - 1]);
  return least;
}

TEST(SignalLevels, AreThoseOfAConverterHoweverLongTheRecording) {
  for (const int samples : {1000, 400000}) {
    std::vector<double> signal(samples);
    for (int k = 0; k < samples; ++k) signal[k] = 0.37e-3 * std::round(0.01 * samples * std::sin(1e-3 * k));
    // Products of integers and a count differ by rounding.
    EXPECT_NEAR(LevelOf(signal), 0.37e-3, 1e-12) << samples;
  }
}

TEST(SignalLevels, OfManyValuesAreTheirSmallestDifference) {
  std::mt19937 random(1);
  std::vector<double> signal(300000);
  // Integers: no difference is so small that it counts as rounding.
  std::uniform_int_distribution<int> integer(0, 100000000);
  for (double& value : signal) value = 7 * integer(random);
  EXPECT_EQ(LevelOf(signal), LeastDifference(signal));
}

}  // namespace
}  // namespace fourpost::signal_levels_test
