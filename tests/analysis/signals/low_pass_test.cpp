#include "analysis/signals/low_pass.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::low_pass_test {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// What the filter makes of a sine, from its answer to a single 1.
Complex Response(const LowPass& filter, double frequency_Hz, double rate_Hz) {
  std::vector<double> impulse(4096);
  impulse[0] = 1;
  filter.Apply(impulse);
  Complex response = 0;
  for (std::size_t k = 0; k < impulse.size(); ++k)
    response += impulse[k] * std::polar(1.0, -2 * pi * frequency_Hz * static_cast<double>(k) / rate_Hz);
  return response;
}

/// Product over the poles of 1 / (s - p), their size 1, at s = i tan(pi f / rate) / tan(pi cutoff / rate).
Complex Butterworth(int order, double cutoff_Hz, double frequency_Hz, double rate_Hz) {
  const Complex s(0, std::tan(pi * frequency_Hz / rate_Hz) / std::tan(pi * cutoff_Hz / rate_Hz));
  Complex response = 1;
  for (int k = 0; k < order; ++k) response /= s - std::polar(1.0, pi * (2 * k + order + 1) / (2 * order));
  return response;
}

// Numbers near the least that there are take a hundred times as long: 80 % of a fit over time, of motions that decay.
TEST(LowPass, WhatHasDecayedIsZero) {
  std::vector<double> signal(30000);
  for (std::size_t k = 0; k < 3000; ++k) signal[k] = std::exp(-0.3 * static_cast<double>(k));
  LowPass(4, 30, 500).Apply(signal);
  EXPECT_GT(signal[100], 1e-14);
  for (const double value : signal) ASSERT_NE(std::fpclassify(value), FP_SUBNORMAL);
  EXPECT_EQ(signal.back(), 0);
}

TEST(LowPass, HasTheResponseOfButterworthsPoles) {
  for (const int order : {1, 2, 3, 4, 5, 8})
    for (const double frequency : {0.5, 10.0, 30.0, 60.0, 200.0}) {
      const Complex expected = Butterworth(order, 30, frequency, 500);
      // Rounding, and what is left of the answer after 4096 samples.
      EXPECT_LT(std::abs(Response(LowPass(order, 30, 500), frequency, 500) - expected), 1e-12)
          << order << ' ' << frequency;
    }
}

TEST(LowPass, HasHalfThePowerAtItsCutOff) {
  for (const int order : {1, 4, 7}) EXPECT_NEAR(std::norm(Response(LowPass(order, 30, 500), 30, 500)), 0.5, 1e-12);
}

// The textbook's example: tan(pi / 4) = 1.
TEST(LowPass, OfSecondOrderAtAQuarterOfTheRate) {
  const std::vector<LowPass::Section> sections = LowPass(2, 1, 4).sections();
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_NEAR(sections[0].b0, 0.2928932188134524, 1e-15);
  EXPECT_NEAR(sections[0].b1, 0.5857864376269049, 1e-15);
  EXPECT_NEAR(sections[0].b2, 0.2928932188134524, 1e-15);
  EXPECT_NEAR(sections[0].a1, 0, 1e-15);
  EXPECT_NEAR(sections[0].a2, 0.1715728752538099, 1e-15);
}

TEST(LowPass, IsCausalAndSettlesAtRest) {
  std::vector<double> step(3000, 1);
  std::fill(step.begin(), step.begin() + 1000, 0);
  LowPass(4, 30, 500).Apply(step);
  EXPECT_EQ(step[999], 0);
  EXPECT_GT(step[1000], 0);
  EXPECT_LT(step[1000], 0.01);
  EXPECT_NEAR(step[2999], 1, 1e-12);
}

/// Radius of the slowest pole: the bilinear transform (1 + w s) / (1 - w s) of the prototype's next to the imaginary
/// axis.
double SlowestRadius(int order) {
  const double angle = pi / 2 + pi / (2 * order);
  const Complex s = std::tan(pi * 30 / 500) * std::polar(1.0, angle);
  return std::abs((1.0 + s) / (1.0 - s));
}

TEST(LowPass, SettlesAsItsSlowestPole) {
  for (const int order : {1, 2, 4, 8, 16}) {
    const std::size_t samples = LowPass(order, 30, 500).SettlingSamples(1e-3);
    EXPECT_EQ(samples, std::ceil(std::log(1e-3) / std::log(SlowestRadius(order)))) << order;
    std::vector<double> impulse(4096);
    impulse[0] = 1;
    LowPass(order, 30, 500).Apply(impulse);
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto end = impulse.begin() + static_cast<std::ptrdiff_t>(samples);
    // A filter of many poles starts late.
    const double left =
        std::abs(*std::max_element(end, impulse.end(), size)) / std::abs(*std::max_element(impulse.begin(), end, size));
    EXPECT_LT(left, 0.01) << order;
    EXPECT_GT(left, 2e-4) << order;
  }
  EXPECT_THROW(LowPass(4, 30, 500).SettlingSamples(1), std::invalid_argument);
}

TEST(LowPass, RefusesWhatCannotBe) {
  EXPECT_THROW(LowPass(0, 30, 500), std::invalid_argument);
  EXPECT_THROW(LowPass(17, 30, 500), std::invalid_argument);
  EXPECT_THROW(LowPass(4, 250, 500), std::invalid_argument);
  EXPECT_THROW(LowPass(4, 0, 500), std::invalid_argument);
  EXPECT_THROW(LowPass(4, std::numeric_limits<double>::quiet_NaN(), 500), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::low_pass_test
