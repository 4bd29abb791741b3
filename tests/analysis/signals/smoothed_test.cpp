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
    const Smoothed smoothed = WithoutNoise(noisy);
    EXPECT_NEAR(smoothed.noise, noise, 0.1 * noise);
    // By a factor of three at least, more where noise is large.
    EXPECT_LT(Rms(Slopes(smoothed.signal), Slopes(clean)), 0.3 * Rms(Slopes(noisy), Slopes(clean))) << noise;
  }
}

TEST(WithoutNoise, ReadsThroughTheLevelsOfAConverter) {
  const std::vector<double> clean = Strokes();
  const double level = 20e-6;
  std::vector<double> coarse = clean;
  for (double& x : coarse) x = level * std::round(x / level);
  const Smoothed smoothed = WithoutNoise(coarse);
  EXPECT_NEAR(smoothed.noise, level / std::sqrt(12.0), 0.2 * level / std::sqrt(12.0));
  EXPECT_LT(Rms(Slopes(smoothed.signal), Slopes(clean)), 0.5 * Rms(Slopes(coarse), Slopes(clean)));
}

TEST(WithoutNoise, LeavesASignalWithoutNoiseAsItIs) {
  const std::vector<double> clean = Strokes();
  const Smoothed smoothed = WithoutNoise(clean);
  // The ends are no smoother than a recording's: nanometres.
  EXPECT_LT(Rms(smoothed.signal, clean), 1e-9);
  EXPECT_EQ(WithoutNoise(std::vector<double>(10, 1)).noise, 0);
}

TEST(WithoutNoise, KeepsTheCornersOfConstantSpeeds) {
  std::vector<double> clean;
  for (int k = 0; k < 10000; ++k) clean.push_back(50e-3 * std::abs(std::fmod(1e-3 * k, 2.0) - 1));
  // What is taken at the corners of strokes at 25 mm/s is no more than half a per cent of the speed.
  const std::vector<double> kept = Slopes(WithoutNoise(clean).signal);
  EXPECT_LT(Rms(kept, Slopes(clean)), 0.005 * 25e-3);
  std::mt19937 random(3);
  std::normal_distribution<double> draw(0, 10e-6);
  std::vector<double> noisy = clean;
  for (double& x : noisy) x += draw(random);
  EXPECT_LT(Rms(Slopes(WithoutNoise(noisy).signal), Slopes(clean)), 0.5 * Rms(Slopes(noisy), Slopes(clean)));
}

TEST(WithoutNoise, KeepsAParabola) {
  // Its third differences are 0: what is least anyway.
  std::vector<double> x;
  for (int k = 0; k < 1000; ++k) x.push_back(1e-3 * k - 1e-6 * k * k);
  EXPECT_LT(Rms(WithoutNoise(x).signal, x), 1e-9);
}

}  // namespace
}  // namespace fourpost::smoothed_test
