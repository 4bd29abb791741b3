#include "analysis/signals/fourier.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/decibel.h"
#include "tests/rounding.h"

namespace fourpost::fourier_test {
namespace {

using std::numbers::pi;

/// Mean, first, second, third harmonic.
const Eigen::VectorXcd kHarmonics =
    (Eigen::VectorXcd(4) << 0.7, std::complex(1.0, -0.4), std::complex(-0.2, 0.3), std::complex(0.05, 0.01)).finished();

/// y(t_n) = Re sum_h Y_h exp(i h w t_n).
std::vector<double> Sample(const Eigen::VectorXcd& harmonics, double samples_per_cycle, std::size_t size) {
  std::vector<double> samples(size);
  for (std::size_t n = 0; n < size; ++n)
    for (Eigen::Index h = 0; h < harmonics.size(); ++h) {
      const double angle = 2 * pi * static_cast<double>(h) * static_cast<double>(n) / samples_per_cycle;
      samples[n] += (harmonics(h) * std::polar(1.0, angle)).real();
    }
  return samples;
}

/// Sums of a few hundred terms of magnitude one: rounding grows with the number of terms at worst.
double Rounding(std::size_t size) { return static_cast<double>(size) * kUlp; }

TEST(Harmonics, OfWholeCyclesAreExact) {
  for (const int cycles : {1, 3, 7}) {
    const std::size_t size = 200;
    const std::vector<double> samples = Sample(kHarmonics, static_cast<double>(size) / cycles, size);
    const Eigen::VectorXcd harmonics = Harmonics(samples, cycles, 3);
    ASSERT_EQ(harmonics.size(), 4);
    EXPECT_LT((harmonics - kHarmonics).cwiseAbs().maxCoeff(), Rounding(size)) << cycles;
  }
}

TEST(Harmonics, OfACycleWithoutAWholeNumberOfSamplesAreExact) {
  // 500 Hz at 30 Hz: 16.67 samples a cycle, but 50 in three.
  const std::vector<double> samples = Sample(kHarmonics, 500.0 / 30, 50);
  EXPECT_LT((Harmonics(samples, 3, 3) - kHarmonics).cwiseAbs().maxCoeff(), Rounding(50));
}

TEST(Harmonics, OfACosineAreRealAndOfASineMinusI) {
  std::vector<double> cosine;
  std::vector<double> sine;
  for (int n = 0; n < 16; ++n) {
    cosine.push_back(std::cos(2 * pi * n / 16));
    sine.push_back(std::sin(2 * pi * n / 16));
  }
  EXPECT_LT(std::abs(Harmonics(cosine, 1, 1)(1) - 1.0), Rounding(16));
  EXPECT_LT(std::abs(Harmonics(sine, 1, 1)(1) - std::complex(0.0, -1.0)), Rounding(16));
}

TEST(Harmonics, OfCountZeroAreTheMean) {
  const std::vector<double> samples = {1, 2, 6};
  const Eigen::VectorXcd harmonics = Harmonics(samples, 1, 0);
  ASSERT_EQ(harmonics.size(), 1);
  EXPECT_EQ(harmonics(0), 3.0);
}

TEST(Harmonics, NeedMoreThanTwoSamplesForEach) {
  const std::vector<double> samples(12, 1.0);
  EXPECT_NO_THROW(Harmonics(samples, 1, 5));
  EXPECT_THROW(Harmonics(samples, 1, 6), std::invalid_argument);
  EXPECT_THROW(Harmonics(samples, 6, 1), std::invalid_argument);
}

TEST(Harmonics, NeedACycleAndSamples) {
  const std::vector<double> samples(12, 1.0);
  EXPECT_THROW(Harmonics(samples, 0, 1), std::invalid_argument);
  EXPECT_THROW(Harmonics(samples, 1, -1), std::invalid_argument);
  EXPECT_THROW(Harmonics({}, 1, 0), std::invalid_argument);
}

TEST(HarmonicsByLeastSquares, AreExactForAnyNumberOfSamples) {
  for (const std::size_t size : {17u, 60u, 203u}) {
    const std::vector<double> samples = Sample(kHarmonics, 500.0 / 30, size);
    const Eigen::VectorXcd harmonics = HarmonicsByLeastSquares(samples, 500.0 / 30, 3);
    ASSERT_EQ(harmonics.size(), 4);
    EXPECT_LT((harmonics - kHarmonics).cwiseAbs().maxCoeff(), Rounding(size)) << size;
  }
}

TEST(HarmonicsByLeastSquares, AgreeWithTheRectangleRuleOnWholeCycles) {
  std::vector<double> samples;
  for (int n = 0; n < 100; ++n) samples.push_back(std::fmod(0.37 * n * n, 1.0));
  const Eigen::VectorXcd difference = Harmonics(samples, 4, 5) - HarmonicsByLeastSquares(samples, 25, 5);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), Rounding(100));
}

TEST(HarmonicsByLeastSquares, AreExactWhereARoundedCountErrsByTenthsOfADecibel) {
  // 500 Hz at 28.5 Hz: 17.54 samples a cycle, rounded to 18. A sine whose error over one cycle is the known 0.2-0.4 dB.
  const double samples_per_cycle = 500 / 28.5;
  const Eigen::VectorXcd sine = (Eigen::VectorXcd(2) << 0, std::complex(0.0, -1.0)).finished();
  const std::vector<double> samples = Sample(sine, samples_per_cycle, 18);
  const double rounded_dB = DecibelFromGain(std::abs(Harmonics(samples, 1, 1)(1)));
  EXPECT_GT(std::abs(rounded_dB), 0.1);
  EXPECT_LT(std::abs(HarmonicsByLeastSquares(samples, samples_per_cycle, 1)(1) - sine(1)), Rounding(18));
}

TEST(HarmonicsByLeastSquares, NeedMoreThanTwoSamplesACycleForEach) {
  const std::vector<double> samples(40, 1.0);
  EXPECT_NO_THROW(HarmonicsByLeastSquares(samples, 10.1, 5));
  EXPECT_THROW(HarmonicsByLeastSquares(samples, 10, 5), std::invalid_argument);
  EXPECT_THROW(HarmonicsByLeastSquares(samples, std::nan(""), 5), std::invalid_argument);
  EXPECT_THROW(HarmonicsByLeastSquares(samples, 10, -1), std::invalid_argument);
}

TEST(HarmonicsByLeastSquares, NeedACycle) {
  const std::vector<double> samples(16, 1.0);
  EXPECT_NO_THROW(HarmonicsByLeastSquares(samples, 16, 2));
  EXPECT_THROW(HarmonicsByLeastSquares(samples, 16.5, 2), std::invalid_argument);
  EXPECT_THROW(HarmonicsByLeastSquares({}, 0.5, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::fourier_test
