#include "analysis/measured_response/moved_band.h"

#include <gtest/gtest.h>

#include "tests/analysis/frequency_response/known_system.h"

namespace fourpost::moved_band_test {
namespace {

constexpr double kRate = 500;
constexpr double kTurn = 2 * std::numbers::pi;

/// Two seconds of rest, a sweep in octaves at the rig's limits, and rest again; with noise of a share of the whole.
std::vector<double> Sweep(double first_Hz, double last_Hz, double duration_s, double noise) {
  std::vector<double> signal(static_cast<std::size_t>(2 * kRate), 0.0);
  double phase = 0;
  const double samples = duration_s * kRate;
  for (double k = 0; k < samples; ++k) {
    const double frequency = first_Hz * std::pow(last_Hz / first_Hz, k / samples);
    phase += kTurn * frequency / kRate;
    signal.push_back(RigAmplitude(frequency) * std::sin(phase));
  }
  signal.resize(signal.size() + static_cast<std::size_t>(5 * kRate), 0.0);
  return Noisy(std::move(signal), noise, 0.02, 1);
}

std::vector<double> FrequenciesOf(const std::vector<double>& sweep) {
  return SweptFrequencies(TrackTone(sweep), kRate, static_cast<double>(sweep.size()) / kRate);
}

// The top is 5 % below the sweep's, and the last window of three cycles is over one and a half cycles before the end.
// At a per cent the posts' noise is a third of what they move by at 30 Hz.
TEST(MovedBand, OfASweepEndsWithIt) {
  for (const double duration_s : {40.0, 120.0, 600.0})
    for (const double noise : {0.0, 0.001, 0.003, 0.01})
      for (const auto& [first_Hz, last_Hz] : {std::pair{0.4, 32.0}, std::pair{30.0, 0.5}, std::pair{1.0, 12.0}}) {
        const std::vector<double> band = FrequenciesOf(Sweep(first_Hz, last_Hz, duration_s, noise));
        ASSERT_EQ(band.size(), 64U);
        const double top_Hz = std::max(first_Hz, last_Hz);
        EXPECT_LT(band.back(), top_Hz) << noise << ' ' << duration_s;
        EXPECT_GT(band.back(), 0.85 * top_Hz) << noise << ' ' << duration_s;
        EXPECT_GE(band.front(), std::min(first_Hz, last_Hz));
        // Sixty periods of the record; else a fifth above the sweep's first, which the first windows of three cycles
        // see.
        const double least_Hz = std::max(60 / duration_s, 1.2 * std::min(first_Hz, last_Hz));
        EXPECT_LT(band.front(), 1.6 * least_Hz) << noise << ' ' << duration_s;
      }
}

TEST(MovedBand, OfASweepHasNoHum) {
  std::vector<double> sweep = Sweep(0.5, 25, 120, 0.001);
  for (std::size_t k = 0; k < sweep.size(); ++k)
    sweep[k] += 2e-5 * std::sin(kTurn * 50 / kRate * static_cast<double>(k));
  EXPECT_LT(FrequenciesOf(sweep).back(), 25);
  EXPECT_GT(FrequenciesOf(sweep).back(), 21);
}

// Of a motion without power above 12 Hz, a pole of fourth order at 6 Hz: noise has the band beyond.
TEST(MovedBand, OfARandomMotionEndsAboveItsNoise) {
  for (const double noise : {0.001, 0.003, 0.01, 0.03}) {
    RandomStream random(7, "motion");
    std::vector<double> motion(static_cast<std::size_t>(300 * kRate));
    for (double& sample : motion) sample = random.Normal();
    for (const double pole_Hz : {0.5, 6.0, 6.0, 6.0, 6.0}) {
      double value = 0;
      for (double& sample : motion) sample = value += kTurn * pole_Hz / kRate * (sample - value);
    }
    const double top_Hz = MovedFrequencies(Noisy(std::move(motion), noise, 0, 1), kRate).back();
    // Density of the motion over that of its noise, about: variance / (pi / 2 * 0.5 Hz) / (1 + (f / 0.5)^2) / (1 + (f /
    // 6)^2)^4 and noise^2 / 250 Hz.
    const double above =
        250 / (0.25 * kTurn) / (1 + 4 * top_Hz * top_Hz) / std::pow(1 + top_Hz * top_Hz / 36, 4) / (noise * noise);
    EXPECT_GT(above, 50) << noise << ' ' << top_Hz;
    EXPECT_GT(top_Hz, 6) << noise;
  }
}

}  // namespace
}  // namespace fourpost::moved_band_test
