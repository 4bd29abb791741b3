#include "analysis/signals/signal_timing.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace fourpost::signal_timing_test {
namespace {

constexpr double kRate_Hz = 500;

/// A sweep from 1 to 9 Hz, so much later.
Eigen::VectorXd Sweep(double delay_s, double gain = 1) {
  Eigen::VectorXd sweep(5000);
  for (Eigen::Index k = 0; k < sweep.size(); ++k) {
    const double t = static_cast<double>(k) / kRate_Hz - delay_s;
    sweep[k] = gain * std::sin(2 * std::numbers::pi * (t + 0.4 * t * t));
  }
  return sweep;
}

TEST(SignalTiming, FindsGainAndDelay) {
  for (const double delay : {-0.1, -0.004, 0.0, 0.0007, 0.02, 0.151}) {
    const SignalTiming timing = TimingOf(Sweep(delay, 1.3), Sweep(0), kRate_Hz);
    // Differences over two samples leave (2 pi 9 Hz 2 ms)^2 / 6 of half a sample.
    EXPECT_NEAR(timing.delay_s, delay, 5e-6) << delay;
    EXPECT_NEAR(timing.gain, 1.3, 3e-3) << delay;
    EXPECT_LT(timing.nmse_percent, 1e-2) << delay;
  }
}

TEST(SignalTiming, FindsAnotherSign) {
  const SignalTiming timing = TimingOf(-Sweep(0.006), Sweep(0), kRate_Hz);
  EXPECT_NEAR(timing.gain, -1, 1e-3);
  EXPECT_NEAR(timing.delay_s, 0.006, 5e-6);
}

TEST(SignalTiming, RefusesWhatCannotBe) {
  EXPECT_THROW(TimingOf(Eigen::VectorXd(10), Eigen::VectorXd(10), kRate_Hz), std::invalid_argument);
  EXPECT_THROW(TimingOf(Sweep(0), Sweep(0).head(100), kRate_Hz), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::signal_timing_test
