#include "analysis/signals/autocorrelation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::autocorrelation_test {
namespace {

constexpr Eigen::Index kSamples = 20000;

/// x_t = a x_{t-1} + e_t.
Eigen::VectorXd Correlated(double correlation, std::uint64_t seed) {
  RandomStream draws(seed, "noise");
  Eigen::VectorXd noise(kSamples);
  for (Eigen::Index k = 0; k < kSamples; ++k) noise[k] = draws.Normal() + (k > 0 ? correlation * noise[k - 1] : 0);
  return noise;
}

TEST(Autocorrelation, FindsTheOrderAndTheSizeOfAnAutoregression) {
  EXPECT_TRUE(Autoregression(Correlated(0, 4)).empty());
  const std::vector<double> coefficients = Autoregression(Correlated(0.8, 5));
  ASSERT_FALSE(coefficients.empty());
  EXPECT_NEAR(coefficients[0], -0.8, 0.03);  // four deviations, (1 - a^2)^1/2 / N^1/2
  EXPECT_EQ(Autoregression(Eigen::VectorXd::Zero(100)).size(), 0U);
}

// (1 - a) / (1 + a) of all.
TEST(Autocorrelation, CountsIndependentSamples) {
  EXPECT_NEAR(EffectiveSamples(Correlated(0.8, 5)) / (kSamples / 9.0), 1, 0.2);
  EXPECT_EQ(EffectiveSamples(Correlated(0, 6)), kSamples);
}

TEST(Autocorrelation, TellsWhiteNoiseFromCorrelatedNoise) {
  const Whiteness of_white = WhitenessOf(Correlated(0, 7));
  EXPECT_TRUE(of_white.IsWhite());
  EXPECT_LT(std::abs(of_white.next), 4 / std::sqrt(double{kSamples}));
  const Whiteness of_correlated = WhitenessOf(Correlated(0.8, 8));
  EXPECT_FALSE(of_correlated.IsWhite());
  EXPECT_NEAR(of_correlated.next, 0.8, 0.03);
  EXPECT_TRUE(WhitenessOf(Eigen::VectorXd::Ones(100)).IsWhite());
}

}  // namespace
}  // namespace fourpost::autocorrelation_test
