#include "analysis/restored_signal.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace fourpost {
namespace {

std::vector<double> Sine(double frequency_Hz) {
  std::vector<double> signal;
  for (int k = 0; k < 500; ++k) {
    const double t = 0.002 * k;
    const double rise = 0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, 5 * t));
    signal.push_back(rise * std::sin(2 * std::numbers::pi * frequency_Hz * t));
  }
  return signal;
}

class Restored : public testing::TestWithParam<int> {};

TEST_P(Restored, IsWhatTheFilterWasGiven) {
  const LowPass filter(GetParam(), 30, 500);
  for (const double frequency_Hz : {1.0, 10.0, 30.0}) {
    const std::vector<double> signal = Sine(frequency_Hz);
    std::vector<double> filtered = signal;
    filter.Apply(filtered);
    const std::vector<double> restored = RestoredSignal(filter, filtered);
    // The first term left out at 30 Hz: C(order/2 + 3, 4) s^4, s = sin^2(0.06 pi).
    const double tolerance = GetParam() == 8 ? 1e-4 : 3e-5;
    // Where the signal begins its third derivative jumps, 12 pi^3 25 f / 4; times the step cubed.
    const double onset = 75 * std::pow(std::numbers::pi, 3) * frequency_Hz * std::pow(0.002, 3);
    for (std::size_t k = 0; k + kRestoringReach < signal.size(); ++k)
      ASSERT_NEAR(restored[k], signal[k], k < kRestoringReach ? tolerance + onset : tolerance)
          << frequency_Hz << " Hz, sample " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, Restored, testing::Values(2, 4, 8));

TEST(RestoredSignal, OfARecordingThatBeginsAwayFromZero) {
  const std::vector<double> level(50, 3.0);
  for (const double value : RestoredSignal(LowPass(4, 30, 500), level)) EXPECT_NEAR(value, 3, 1e-12);
}

TEST(RestoredSignal, RefusesOddOrders) {
  EXPECT_THROW(RestoredSignal(LowPass(3, 30, 500), std::vector<double>(9)), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost
