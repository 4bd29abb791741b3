#include "analysis/signals/signal_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fourpost::signal_levels_test {
namespace {

TEST(SignalLevels, AreThoseOfAConverterHoweverLongTheRecording) {
  for (const int samples : {1000, 400000}) {
    std::vector<double> signal(samples);
    for (int k = 0; k < samples; ++k) signal[k] = 0.37e-3 * std::round(0.01 * samples * std::sin(1e-3 * k));
    // Products of integers and a count differ by rounding.
    EXPECT_NEAR(LevelOf(signal), 0.37e-3, 1e-12) << samples;
  }
}

TEST(SignalLevels, OfManyValuesAreTheirSmallestDifference) {
  std::vector<double> signal(300000);
  for (std::size_t k = 0; k < signal.size(); ++k) signal[k] = 10 * static_cast<double>(k);
  EXPECT_EQ(LevelOf(signal), 10);
  signal.back() += 3;
  signal.push_back(signal.back() + 4);
  EXPECT_EQ(LevelOf(signal), 4);
}

}  // namespace
}  // namespace fourpost::signal_levels_test
