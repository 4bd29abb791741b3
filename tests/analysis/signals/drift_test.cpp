#include "analysis/signals/drift.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::drift_test {
namespace {

constexpr double kRate = 200;

std::vector<double> Sine(double frequency_Hz, std::size_t samples, double phase = 0) {
  std::vector<double> signal;
  for (std::size_t k = 0; k < samples; ++k)
    signal.push_back(std::sin(2 * std::numbers::pi * frequency_Hz * static_cast<double>(k) / kRate + phase));
  return signal;
}

/// Largest, away from the ends.
double Amplitude(const std::vector<double>& signal) {
  double largest = 0;
  for (std::size_t k = signal.size() / 4; k < 3 * signal.size() / 4; ++k)
    largest = std::max(largest, std::abs(signal[k]));
  return largest;
}

TEST(Drift, TrendIsTheLineOfLeastSquares) {
  const std::vector<double> line = {3, 5, 7, 9};
  EXPECT_DOUBLE_EQ(TrendOf(line).first, 3);
  EXPECT_DOUBLE_EQ(TrendOf(line).last, 9);
  std::vector<double> signal = {1, 0, 2, 1};
  RemoveTrend(signal);
  // By hand: slope 0.2 about the mean 1.
  const std::vector<double> left = {0.3, -0.9, 0.9, -0.3};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(signal[k], left[k], 1e-15);
}

TEST(Drift, WhatIsSlowGoesWithoutAShift) {
  for (const double ratio : {1.0, 2.0, 4.0}) {
    const double frequency_Hz = 2;
    std::vector<double> signal = Sine(frequency_Hz, 8000);
    const std::vector<double> before = signal;
    RemoveSlow(signal, kRate, frequency_Hz / ratio);
    // |1 - 1/(1 + (f/fc)^4)|; warping of the bilinear transform is (pi f / rate)^2 / 3, below 4e-4.
    const double left = 1 - 1 / (1 + std::pow(ratio, 4));
    EXPECT_NEAR(Amplitude(signal), left, 1e-3) << ratio;
    double product = 0;
    double quadrature = 0;
    const std::vector<double> turned = Sine(frequency_Hz, 8000, std::numbers::pi / 2);
    for (std::size_t k = 2000; k < 6000; ++k) {
      product += signal[k] * before[k];
      quadrature += signal[k] * turned[k];
    }
    EXPECT_LT(std::abs(quadrature / product), 1e-3) << ratio;
  }
  std::vector<double> ramp(4000);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = 5 + 0.01 * static_cast<double>(k);
  RemoveSlow(ramp, kRate, 1);
  // Ends are reflected, so that a line goes on as itself; what the filter forgets is 1e-4 of 40.
  for (const double value : ramp) EXPECT_NEAR(value, 0, 1e-2);
}

TEST(Drift, IntegralOfASineIsItsCosine) {
  const double frequency_Hz = kRate / 16;
  const std::vector<double> integral = IntegralOf(Sine(frequency_Hz, 400), kRate);
  const double w = 2 * std::numbers::pi * frequency_Hz;
  for (std::size_t k = 0; k < integral.size(); ++k) {
    const double exact = (1 - std::cos(w * static_cast<double>(k) / kRate)) / w;
    // 11/720 (w h)^4 = 3.6e-4 of the amplitude; its first step is a straight line, (w h)^3 / 12.
    EXPECT_NEAR(integral[k], exact, (8e-4 + 5.1e-3) / w);
  }
}

}  // namespace
}  // namespace fourpost::drift_test
