#include "analysis/signals/smoothed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace fourpost::smoothed_test {
namespace {

constexpr double kRate_Hz = 500;

/// Strokes of 25 mm, from 1 to 6 Hz in half a minute [m].
std::vector<double> Strokes() {
  std::vector<double> x;
  for (int k = 0; k < 30 * kRate_Hz; ++k) {
    const double t = k / kRate_Hz;
    x.push_back(25e-3 * std::sin(2 * std::numbers::pi * (t + t * t / 12)));
  }
  return x;
}

double Rms(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

std::vector<double> Slopes(const std::vector<double>& x) {
  std::vector<double> slopes;
  for (std::size_t k = 1; k + 1 < x.size(); ++k) slopes.push_back((x[k + 1] - x[k - 1]) * kRate_Hz / 2);
  return slopes;
}

TEST(WithoutNoise, TakesMostOfTheNoiseOfTheRateAway) {
  const std::vector<double> clean = Strokes();
  for (const double noise : {1e-6, 1e-5, 1e-4}) {
    std::mt19937 random(3);
    std::normal_distribution<double> draw(0, noise);
    std::vector<double> noisy = clean;
    for (double& x : noisy) x += draw(random);
    EXPECT_LT(Rms(Slopes(WithoutNoise(noisy)), Slopes(clean)), 0.4 * Rms(Slopes(noisy), Slopes(clean))) << noise;
  }
}

TEST(WithoutNoise, ReadsThroughTheLevelsOfAConverter) {
  const std::vector<double> clean = Strokes();
  std::vector<double> coarse = clean;
  for (double& x : coarse) x = 20e-6 * std::round(x / 20e-6);
  EXPECT_LT(Rms(Slopes(WithoutNoise(coarse)), Slopes(clean)), 0.5 * Rms(Slopes(coarse), Slopes(clean)));
}

/// Of a sweep at constant speed the fastest motion is the smallest.
TEST(WithoutNoise, TakesNothingOfTheFastestMotionOfASweep) {
  for (const double rate_Hz : {100.0, 200.0, 500.0})
    for (const double noise : {1e-5, 5e-5}) {
      std::mt19937 random(5);
      std::normal_distribution<double> draw(0, noise);
      std::vector<double> clean;
      std::vector<double> noisy;
      for (double t = 0; t < 40; t += 1 / rate_Hz) {
        const double f = 0.5 + 19.5 * t / 40;
        clean.push_back(0.15 / (2 * std::numbers::pi * f) *
                        std::sin(2 * std::numbers::pi * (0.5 * t + 19.5 * t * t / 80)));
        noisy.push_back(clean.back() + draw(random));
      }
      const std::vector<double> smooth = WithoutNoise(noisy);
      double product = 0;
      double squares = 0;
      // The last two seconds but for the end, about 19 Hz.
      for (std::size_t k = clean.size() - static_cast<std::size_t>(2.5 * rate_Hz);
           k < clean.size() - static_cast<std::size_t>(0.5 * rate_Hz); ++k) {
        product += smooth[k] * clean[k];
        squares += clean[k] * clean[k];
      }
      // Two thousandths by the weight, and three standard deviations of the noise that is left.
      EXPECT_NEAR(product / squares, 1, 0.002 + 3 * noise / std::sqrt(squares)) << rate_Hz << ", " << noise;
    }
}

TEST(WithoutNoise, LeavesASignalWithoutNoiseAsItIs) {
  const std::vector<double> clean = Strokes();
  // But for its ends: nanometres.
  EXPECT_LT(Rms(WithoutNoise(clean), clean), 1e-9);
  // Three samples a period are not taken for noise.
  std::vector<double> fast;
  for (int k = 0; k < 3000; ++k) fast.push_back(std::sin(2 * std::numbers::pi * k / 3.01));
  EXPECT_EQ(WithoutNoise(fast), fast);
  const std::vector<double> few(10, 1);
  EXPECT_EQ(WithoutNoise(few), few);
}

TEST(WithoutNoise, KeepsTheCornersOfConstantSpeeds) {
  std::vector<double> clean;
  for (int k = 0; k < 10000; ++k) clean.push_back(50e-3 * std::abs(std::fmod(1e-3 * k, 2.0) - 1));
  // What is taken at the corners of strokes at 25 mm/s is no more than half a per cent of the speed.
  const std::vector<double> kept = Slopes(WithoutNoise(clean));
  EXPECT_LT(Rms(kept, Slopes(clean)), 0.005 * 25e-3);
  std::mt19937 random(3);
  std::normal_distribution<double> draw(0, 10e-6);
  std::vector<double> noisy = clean;
  for (double& x : noisy) x += draw(random);
  EXPECT_LT(Rms(Slopes(WithoutNoise(noisy)), Slopes(clean)), 0.5 * Rms(Slopes(noisy), Slopes(clean)));
}

TEST(WithoutNoise, KeepsAParabola) {
  // Its fourth differences are 0: what is least anyway.
  std::vector<double> x;
  for (int k = 0; k < 1000; ++k) x.push_back(1e-3 * k - 1e-6 * k * k);
  EXPECT_LT(Rms(WithoutNoise(x), x), 1e-9);
}

}  // namespace
}  // namespace fourpost::smoothed_test
