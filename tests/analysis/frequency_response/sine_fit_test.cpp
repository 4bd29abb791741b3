#include "analysis/frequency_response/sine_fit.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/frequency_response/settled_part.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/random_stream.h"

namespace fourpost::sine_fit_test {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using Signals = std::vector<std::span<const double>>;

constexpr double kRounding = 1e-10;

TEST(SineFit, IsExactForHarmonicsOffsetAndDrift) {
  const double f = 0.0123;
  std::vector<double> signal;
  for (int k = 0; k < 1000; ++k) {
    double value = 4 + 0.002 * k;
    for (int h = 1; h <= 5; ++h) value += std::cos(2 * pi * h * f * k + 0.3 * h) / h;
    signal.push_back(value);
  }
  const std::vector<SineFit> fits = FitSines(Signals{signal}, 100, 900, f, 5, 0);
  ASSERT_EQ(fits.size(), 1U);
  for (int h = 1; h <= 5; ++h)
    EXPECT_LT(std::abs(fits[0].phasor[static_cast<std::size_t>(h - 1)] - std::polar(1.0 / h, 0.3 * h)), kRounding);
  EXPECT_NEAR(fits[0].mean, 4 + 0.002 * 499.5, kRounding);
}

TEST(SineFit, RefusesWhatCannotBeFitted) {
  const std::vector<double> signal(100, 1.0);
  EXPECT_THROW(FitSines(Signals{signal}, 0, 8, 0.01, 5, 0), std::invalid_argument);
  EXPECT_THROW(FitSines(Signals{signal}, 0, 90, 0.5, 1, 0), std::invalid_argument);
}

TEST(SineFit, RefinesAFrequency) {
  std::vector<double> signal;
  for (int k = 0; k < 4000; ++k) signal.push_back(1 + std::sin(2 * pi * 0.01234567 * k));
  // Each cycle's fit is exact, so that rounding alone is left.
  EXPECT_NEAR(RefinedFrequency(signal, 0, 4000, 0.01235), 0.01234567, 1e-13);
}

TEST(SettledPart, CutsARunIn) {
  RandomStream random(1, "test");
  std::vector<Complex> blocks;
  for (int k = 0; k < 40; ++k)
    blocks.push_back(1.0 + 0.3 * std::exp(-k / 3.0) + 0.003 * Complex(random.Normal(), random.Normal()));
  const SettledPart settled = SettledPartOf(std::vector<std::vector<Complex>>{blocks});
  EXPECT_TRUE(settled.is_settled);
  // The transient falls to the noise of a block after 14 of them.
  EXPECT_GE(settled.first, 8U);
  EXPECT_LE(settled.first, 18U);
}

TEST(SettledPart, OfAStationarySeriesIsAllButTheFirstBlock) {
  int cut = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomStream random(seed, "test");
    std::vector<std::vector<Complex>> signals(10);
    for (std::vector<Complex>& blocks : signals)
      for (int k = 0; k < 20; ++k) blocks.push_back(1.0 + 0.01 * Complex(random.Normal(), random.Normal()));
    if (SettledPartOf(signals).first > 1) ++cut;
  }
  // One in a thousand by design; few blocks know their scatter poorly.
  EXPECT_LE(cut, 4);
}

TEST(SettledPart, SaysWhatNeverSettles) {
  std::vector<Complex> blocks;
  for (int k = 0; k < 20; ++k) blocks.push_back(1.0 + 0.05 * k);
  EXPECT_FALSE(SettledPartOf(std::vector<std::vector<Complex>>{blocks}).is_settled);
}

/// Of independent and of correlated numbers, x_k = 0.7 x_(k-1) + e_k, whose mean has (1 / 0.3)^2 times the variance.
TEST(VarianceOfMean, IsThatOfTheMean) {
  for (const double memory : {0.0, 0.7}) {
    double stated = 0;
    double real = 0;
    constexpr int kSeries = 400;
    for (std::uint64_t seed = 1; seed <= kSeries; ++seed) {
      RandomStream random(seed, "test");
      std::vector<Complex> series;
      Complex value;
      for (int k = 0; k < 260; ++k) {
        value = memory * value + Complex(random.Normal(), random.Normal());
        if (k >= 60) series.push_back(value);
      }
      Complex mean;
      for (const Complex& each : series) mean += each / 200.0;
      stated += VarianceOfMean(series) / kSeries;
      real += std::norm(mean) / kSeries;
    }
    // 400 squares of complex numbers have a mean good to 5 %, the larger of two estimates is above both.
    EXPECT_GT(stated / real, 0.85) << memory;
    EXPECT_LT(stated / real, 1.4) << memory;
  }
}

// Three to eight numbers know their scatter poorly; 1.96 deviations must hold the truth as often as of many.
TEST(VarianceOfMean, OfFewNumbersCovers) {
  for (const std::size_t size : {3U, 4U, 8U}) {
    int within = 0;
    constexpr int kSeries = 1000;
    for (std::uint64_t seed = 1; seed <= kSeries; ++seed) {
      RandomStream random(seed, "test");
      std::vector<Complex> series;
      Complex mean;
      for (std::size_t k = 0; k < size; ++k) {
        series.emplace_back(random.Normal(), random.Normal());
        mean += series.back() / static_cast<double>(size);
      }
      const double limit = 1.96 * std::sqrt(VarianceOfMean(series) / 2);
      within += (std::abs(mean.real()) < limit ? 1 : 0) + (std::abs(mean.imag()) < limit ? 1 : 0);
    }
    // 2000 numbers: 95 % within 1.5, three standard deviations.
    EXPECT_NEAR(100.0 * within / (2.0 * kSeries), 95, 1.5) << size;
  }
}

// Offsets of cycles are real: half as many degrees of freedom, also of twelve and of correlated ones.
TEST(VarianceOfMean, OfFewRealNumbersCovers) {
  for (const std::size_t size : {3U, 4U, 5U, 6U, 7U, 8U, 9U, 12U}) {
    int within = 0;
    constexpr int kSeries = 4000;
    for (std::uint64_t seed = 1; seed <= kSeries; ++seed) {
      RandomStream random(seed, "test");
      std::vector<double> series;
      for (std::size_t k = 0; k < size; ++k) series.push_back(random.Normal());
      const double limit = 1.96 * std::sqrt(VarianceOfMean(std::span<const double>(series)));
      within += std::abs(Mean(series)) < limit ? 1 : 0;
    }
    // 4000 numbers: 95 % within 1.04, three standard deviations.
    EXPECT_NEAR(100.0 * within / kSeries, 95, 1.04) << size;
  }
}

}  // namespace
}  // namespace fourpost::sine_fit_test
