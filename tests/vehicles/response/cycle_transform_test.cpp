#include "vehicles/response/cycle_transform.h"

#include <complex>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

namespace fourpost::cycle_transform_test {
namespace {

using Complex = std::complex<double>;

constexpr double kRounding = 1e-14;

TEST(CycleTransform, SamplesTheSeries) {
  const CycleTransform transform(2, 8);
  Eigen::MatrixXcd harmonics(3, 1);
  harmonics << 0.5, Complex(1, -2), Complex(0, 3);
  Eigen::MatrixXd time;
  transform.ToTime(harmonics, time);
  ASSERT_EQ(time.rows(), 8);
  for (int k = 0; k < 8; ++k) {
    const double wt = 2 * std::numbers::pi * k / 8;
    EXPECT_NEAR(time(k, 0), 0.5 + std::cos(wt) + 2 * std::sin(wt) - 3 * std::sin(2 * wt), kRounding);
  }
}

TEST(CycleTransform, GivesBackWhatItSampled) {
  const CycleTransform transform(3, 12);
  Eigen::MatrixXcd harmonics(4, 2);
  harmonics << 1, -2, Complex(3, 4), Complex(5, -6), Complex(0, 1), Complex(2, 0), Complex(-1, 1), Complex(7, 7);
  Eigen::MatrixXd time;
  Eigen::MatrixXcd again;
  transform.ToTime(harmonics, time);
  transform.ToHarmonics(time, again);
  EXPECT_LT((again - harmonics).cwiseAbs().maxCoeff(), kRounding * 10);
}

// cos(5 wt) sampled 8 times is cos(3 wt).
TEST(CycleTransform, AliasesWhatIsSampledTooSeldom) {
  const CycleTransform transform(3, 8);
  Eigen::MatrixXd time(8, 1);
  for (int k = 0; k < 8; ++k) time(k, 0) = std::cos(5 * 2 * std::numbers::pi * k / 8);
  Eigen::MatrixXcd harmonics;
  transform.ToHarmonics(time, harmonics);
  EXPECT_LT(std::abs(harmonics(3, 0) - 1.0), kRounding);
}

// The folding of quarters against the sums that define it, with odd and even numbers of harmonics.
TEST(CycleTransform, IsTheSumOfItsHarmonics) {
  for (const auto& [count, samples] : {std::pair(1, 4), std::pair(4, 12), std::pair(5, 16), std::pair(9, 64)}) {
    const CycleTransform transform(count, samples);
    const Eigen::MatrixXcd harmonics = Eigen::MatrixXcd::Random(count + 1, 2);
    Eigen::MatrixXd time;
    transform.ToTime(harmonics, time);
    for (int k = 0; k < samples; ++k)
      for (int j = 0; j < 2; ++j) {
        Complex sum = 0;
        for (int h = 0; h <= count; ++h)
          sum += harmonics(h, j) * std::polar(1.0, 2 * std::numbers::pi * h * k / samples);
        EXPECT_NEAR(time(k, j), sum.real(), 10 * kRounding) << count << " harmonics, sample " << k;
      }
  }
}

TEST(CycleTransform, RefusesSamplesThatCannotHoldTheHarmonics) {
  EXPECT_THROW(CycleTransform(3, 6), std::invalid_argument);
  EXPECT_THROW(CycleTransform(4, 8), std::invalid_argument);
  EXPECT_THROW(CycleTransform(3, 10), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::cycle_transform_test
