#include "analysis/signals/held_samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::held_samples_test {
namespace {

using Signals = std::vector<std::vector<double>>;

/// 4 s at 500 Hz.
Signals Sampled(const std::vector<std::function<double(double)>>& signals) {
  Signals sampled;
  for (const auto& signal : signals) {
    sampled.emplace_back();
    for (int k = 0; k < 2000; ++k) sampled.back().push_back(signal(0.002 * k));
  }
  return sampled;
}

double Swing(double t, double frequency_Hz) { return std::sin(2 * std::numbers::pi * frequency_Hz * t); }

Signals MovingCar() {
  return Sampled({[](double t) { return Swing(t, 1.3); }, [](double t) { return Swing(t + 0.1, 2.7); },
                  [](double t) { return Swing(t + 0.2, 11); }});
}

void Hold(Signals& signals, std::size_t first, std::size_t last) {
  for (std::vector<double>& signal : signals)
    for (std::size_t k = first; k <= last; ++k) signal[k] = signal[first - 1];
}

TEST(HeldSamples, AreFoundWhereAllChannelsStandAndThenJump) {
  Signals signals = MovingCar();
  Hold(signals, 700, 749);
  const std::vector<HeldSamples> held = HeldStretches(signals);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_EQ(held[0].first, 700U);
  EXPECT_EQ(held[0].last, 749U);
}

TEST(HeldSamples, AreFoundInNoise) {
  Signals signals = MovingCar();
  RandomStream random(7, "noise");
  for (std::vector<double>& signal : signals)
    for (double& value : signal) value += 0.02 * random.Normal();
  Hold(signals, 1000, 1059);
  EXPECT_EQ(HeldStretches(signals).size(), 1U);
}

TEST(HeldSamples, AreNotThoseOfOneChannel) {
  Signals signals = MovingCar();
  for (std::size_t k = 700; k < 750; ++k) signals[1][k] = signals[1][699];
  EXPECT_TRUE(HeldStretches(signals).empty());
}

TEST(HeldSamples, AreNoRestBeforeOrBetweenMotions) {
  // Quantised, as a converter does it, so that a decay ends in a constant.
  const auto decay = [](double t, double phase) {
    if (t < 0.5) return 0.0;
    const double since = std::fmod(t - 0.5, 1.5);
    return std::round(1e3 * std::exp(-8 * since) * std::cos(20 * since + phase)) / 1e3;
  };
  EXPECT_TRUE(
      HeldStretches(Sampled({[&](double t) { return decay(t, 0); }, [&](double t) { return decay(t, 1); }})).empty());
}

// A damper on its bench: its force jumps where the displacement's ramp goes on.
TEST(HeldSamples, AreNoPausesOfARamp) {
  const auto position = [](double t) {
    const double phase = std::fmod(t, 1.0);
    return phase < 0.5 ? std::min(phase, 0.25) : std::max(0.75 - phase, 0.0);
  };
  const auto force = [](double t) {
    const double phase = std::fmod(t, 1.0);
    return phase < 0.25 ? 1.0 : phase >= 0.5 && phase < 0.75 ? -1.0 : 0.0;
  };
  EXPECT_TRUE(HeldStretches(Sampled({position, force})).empty());
}

TEST(HeldSamples, NeedTwoSignalsOfOneLength) {
  Signals signals = MovingCar();
  Hold(signals, 700, 749);
  EXPECT_TRUE(HeldStretches(std::vector<std::vector<double>>{signals[0]}).empty());
  signals[1].pop_back();
  EXPECT_TRUE(HeldStretches(signals).empty());
}

}  // namespace
}  // namespace fourpost::held_samples_test
