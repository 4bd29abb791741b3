#include "vehicles/cycle_transform.h"

#include <complex>

#include <gtest/gtest.h>

namespace fourpost {
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
  const CycleTransform transform(3, 7);
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

}  // namespace
}  // namespace fourpost
