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

std::size_t CountOf(const Signals& signals) {
  std::size_t count = 0;
  for (const std::vector<HeldSamples>& held : HeldStretches(signals)) count += held.size();
  return count;
}

void AddNoise(std::vector<double>& signal, double sd) {
  RandomStream random(7, "noise");
  for (double& value : signal) value += sd * random.Normal();
}

TEST(HeldSamples, AreFoundInAllChannels) {
  Signals signals = MovingCar();
  // Posts that rest say nothing.
  signals.insert(signals.begin(), 4, std::vector<double>(2000, 0.1));
  Hold(signals, 700, 749);
  const auto held = HeldStretches(signals);
  ASSERT_EQ(held.size(), 7U);
  EXPECT_TRUE(held[3].empty());
  for (std::size_t i = 4; i < 7; ++i) {
    ASSERT_EQ(held[i].size(), 1U);
    EXPECT_EQ(held[i][0].first, 700U);
    EXPECT_EQ(held[i][0].last, 749U);
  }
}

TEST(HeldSamples, AreFoundInNoise) {
  Signals signals = MovingCar();
  for (std::vector<double>& signal : signals) AddNoise(signal, 0.02);
  Hold(signals, 1000, 1059);
  EXPECT_EQ(CountOf(signals), 3U);
}

TEST(HeldSamples, AreFoundInOneChannel) {
  Signals signals = MovingCar();
  for (std::size_t k = 700; k < 750; ++k) signals[1][k] = signals[1][699];
  EXPECT_EQ(HeldStretches(signals)[1].size(), 1U);
  EXPECT_EQ(CountOf(signals), 1U);
  // Nine samples of noise, wherever they end.
  AddNoise(signals[2], 0.3);
  for (std::size_t k = 1200; k < 1212; ++k) signals[2][k] = signals[2][1199];
  EXPECT_EQ(HeldStretches(signals)[2].size(), 1U);
}

TEST(HeldSamples, HoldNoGoodSampleAfterAFallToZero) {
  Signals signals = MovingCar();
  for (std::size_t k = 610; k < 640; ++k) signals[0][k] = 0;
  const auto held = HeldStretches(signals);
  ASSERT_EQ(held[0].size(), 1U);
  EXPECT_EQ(held[0][0].first, 610U);
  EXPECT_EQ(held[0][0].last, 639U);
}

TEST(HeldSamples, AreNoneOfAClippedChannel) {
  Signals signals = MovingCar();
  AddNoise(signals[1], 0.05);
  for (double& value : signals[1]) value = std::min(value, 0.8);
  EXPECT_EQ(CountOf(signals), 0U);
}

TEST(HeldSamples, AreNoRestBeforeOrBetweenMotions) {
  // Quantised, as a converter does it, so that a decay ends in a constant.
  const auto decay = [](double t, double phase) {
    if (t < 0.5) return 0.0;
    const double since = std::fmod(t - 0.5, 1.5);
    return std::round(1e3 * std::exp(-8 * since) * std::cos(20 * since + phase)) / 1e3;
  };
  EXPECT_EQ(CountOf(Sampled({[&](double t) { return decay(t, 0); }, [&](double t) { return decay(t, 1); }})), 0U);
}

/// Up within `rise_s`, a plateau, and down again, once a second.
double Plateau(double t, double rise_s) {
  const double phase = std::fmod(t, 1.0);
  return phase < 0.5 ? std::min(phase / rise_s, 1.0) : std::max(1 - (phase - 0.5) / rise_s, 0.0);
}

// Of drives and dampers on a bench, from leisurely to a step within one sample: what goes on after a plateau goes on
// where it was.
TEST(HeldSamples, AreNoPlateaus) {
  for (const double rise_s : {0.25, 0.02, 0.002}) {
    const auto post = [&](double t) { return 0.05 * Plateau(t, rise_s); };
    const auto force = [&](double t) { return Plateau(t + 0.002, rise_s) - Plateau(t, rise_s); };
    EXPECT_EQ(CountOf(Sampled({post, force})), 0U) << rise_s;
    EXPECT_EQ(CountOf(Sampled({post, post, post, post})), 0U) << rise_s;
  }
}

// A bus at 50 Hz, and a converter of few levels.
TEST(HeldSamples, AreNoRepeatedOrCoarseValues) {
  const auto repeated = [](double t) { return Swing(std::floor(50 * t + 1e-9) / 50, 1.3); };
  EXPECT_EQ(CountOf(Sampled({repeated, repeated})), 0U);
  const auto coarse = [](double t) { return std::round(10 * Swing(t, 0.3)) / 10; };
  EXPECT_EQ(CountOf(Sampled({coarse, [&](double t) { return coarse(t + 0.1); }})), 0U);
}

TEST(HeldSamples, NeedSignalsOfOneLength) {
  Signals signals = MovingCar();
  Hold(signals, 700, 749);
  signals[1].pop_back();
  EXPECT_EQ(CountOf(signals), 0U);
  EXPECT_TRUE(HeldStretches(Signals()).empty());
}

}  // namespace
}  // namespace fourpost::held_samples_test
