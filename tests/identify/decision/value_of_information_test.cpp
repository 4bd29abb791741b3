#include "identify/decision/value_of_information.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "identify/search/draws.h"

namespace fourpost::value_of_information_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double Below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double Density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); }
/// E[(Z - c)^+]
double Excess(double c) { return Density(c) - c * Below(-c); }

/// Independent columns of mean 0 and variance 1, exactly.
MatrixXd Orthogonal(Index rows, Index columns, std::uint64_t seed) {
  MatrixXd x(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i)
      x(i, j) = Draws(seed, DrawPurpose::kNoise, j, static_cast<std::size_t>(i)).Normal();
    x.col(j).array() -= x.col(j).mean();
    for (Index k = 0; k < j; ++k) x.col(j) -= x.col(k).dot(x.col(j)) / x.col(k).squaredNorm() * x.col(k);
    x.col(j) *= std::sqrt(static_cast<double>(rows - 1)) / x.col(j).norm();
  }
  return x;
}

TEST(ExpectedRise, OfTwoLinesIsTheClosedForm) {
  for (const double gap : {0.0, 0.3, 2.0, 8.0})
    for (const double slope : {0.5, -1.5}) {
      const double size = std::abs(slope);
      EXPECT_NEAR(ExpectedRise(Eigen::Vector2d(1, 1 - gap), Eigen::Vector2d(0, slope)), size * Excess(gap / size),
                  1e-15)
          << gap << ' ' << slope;
    }
}

// By the trapezoidal rule, which is exact to rounding for a smooth function and here errs at the corners only.
TEST(ExpectedRise, IsTheIntegral) {
  Draws draws(1, DrawPurpose::kProbe, 0, 0);
  for (int round = 0; round < 20; ++round) {
    VectorXd a(12);
    VectorXd b(12);
    for (Index i = 0; i < a.size(); ++i) {
      a[i] = draws.Normal();
      // Some are parallel.
      b[i] = static_cast<double>(draws.Integer(-3, 3));
    }
    constexpr double kStep = 1e-3;
    double sum = 0;
    for (double z = -9; z <= 9; z += kStep) sum += kStep * Density(z) * (a + b * z).maxCoeff();
    // A corner of slope s within a cell: s step^2 / 8 at most.
    EXPECT_NEAR(ExpectedRise(a, b), sum - a.maxCoeff(), 1e-6);
  }
}

TEST(ExpectedRise, IsZeroOfEqualSlopes) {
  EXPECT_EQ(ExpectedRise(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 4, 4)), 0);
  EXPECT_THROW(ExpectedRise(VectorXd(), VectorXd()), std::invalid_argument);
}

// The difference is 0.5 + 3 x1 + x2: shares of 0.9 and 0.1, none of the others.
TEST(DecidingParameters, AreThoseOfALinearDifference) {
  constexpr Index kDraws = 400;
  const MatrixXd x = Orthogonal(kDraws, 4, 2);
  MatrixXd cost(2, kDraws);
  cost.row(0) = 10 * x.col(3).transpose();
  cost.row(1) = cost.row(0) + (0.5 + 3 * x.col(1).array() + x.col(2).array()).matrix().transpose();
  const std::vector<DecidingParameter> deciding = DecidingParameters(cost, 0, 1, x);
  ASSERT_EQ(deciding.size(), 4U);
  EXPECT_EQ(deciding[0].parameter, 1U);
  EXPECT_EQ(deciding[1].parameter, 2U);
  // The correction for chance takes (1 - r^2) / n.
  EXPECT_NEAR(deciding[0].explained, 0.9, 0.1 / 398 + 1e-9);
  EXPECT_NEAR(deciding[1].explained, 0.1, 0.9 / 398 + 1e-9);
  // Knowing x1, the second setting is taken where 0.5 + 3 x1 < 0. Ten standard errors of these draws at most.
  EXPECT_NEAR(deciding[0].gain, 3 * Excess(0.5 / 3), 10 * 3 / std::sqrt(kDraws) / 10);
  EXPECT_NEAR(deciding[1].gain, 1 * Excess(0.5), 0.1);
  for (const std::size_t k : {2U, 3U}) {
    EXPECT_EQ(deciding[k].explained, 0);
    EXPECT_EQ(deciding[k].gain, 0);
  }
}

TEST(DecidingParameters, NeedDraws) {
  EXPECT_TRUE(DecidingParameters(MatrixXd::Random(2, 9), 0, 1, MatrixXd::Random(9, 3)).empty());
}

// One setting of known cost, and one of mean 0.2 and sd 1: a run with noise 0.5 moves its mean by sd 1 / sqrt(1.25).
TEST(InformativeRuns, GainTheClosedFormOfOneDoubtfulSetting) {
  const MatrixXd x = Orthogonal(200, 1, 3);
  MatrixXd cost(2, 200);
  cost.row(0).setZero();
  cost.row(1) = (0.2 + x.col(0).array()).matrix().transpose();
  const std::vector<InformativeRun> runs = InformativeRuns(cost, 0.5, 2);
  // A run of the certain setting gains nothing, and the doubtful one is not repeated.
  ASSERT_EQ(runs.size(), 1U);
  const double moved = 1 / std::sqrt(1.25);
  EXPECT_EQ(runs[0].setting, 1U);
  EXPECT_NEAR(runs[0].gain, moved * Excess(0.2 / moved), 1e-12);
  EXPECT_NEAR(runs[0].sd_before, 1, 1e-12);
  EXPECT_NEAR(runs[0].sd_after, std::sqrt(0.25 / 1.25), 1e-12);
}

/// One setting is in much more doubt than two others: its noisy run would be worth more again than theirs.
TEST(InformativeRuns, AreOfDistinctSettingsEachGivenThoseBefore) {
  const MatrixXd x = Orthogonal(200, 3, 5);
  MatrixXd cost(4, 200);
  cost.row(0).setZero();
  cost.row(1) = (0.1 + x.col(0).array()).matrix().transpose();
  cost.row(2) = (0.2 + 0.3 * x.col(1).array()).matrix().transpose();
  cost.row(3) = (0.3 + 0.1 * x.col(2).array() + 0.5 * x.col(0).array()).matrix().transpose();
  constexpr double kNoise = 0.5;
  const std::vector<InformativeRun> runs = InformativeRuns(cost, kNoise, 5);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].setting, 1U);
  std::set<std::size_t> settings;
  for (const InformativeRun& run : runs) settings.insert(run.setting);
  EXPECT_EQ(settings.size(), runs.size());
  // Setting 3 shares the doubt of setting 1: its variance 0.26 falls by 0.5^2 / (1 + 0.25) with the first run.
  const auto third = std::find_if(runs.begin(), runs.end(), [](const InformativeRun& run) { return run.setting == 3; });
  EXPECT_NEAR(third->sd_before, std::sqrt(0.26 - 0.25 / 1.25), 1e-12);
}

// Settings that move together are known by one run.
TEST(InformativeRuns, KnowByCorrelation) {
  const MatrixXd x = Orthogonal(200, 2, 4);
  MatrixXd cost(3, 200);
  cost.row(0).setZero();
  cost.row(1) = (0.1 + x.col(0).array()).matrix().transpose();
  cost.row(2) = (0.1 + x.col(0).array() + 1e-3 * x.col(1).array()).matrix().transpose();
  const std::vector<InformativeRun> runs = InformativeRuns(cost, 0.01, 5);
  ASSERT_GE(runs.size(), 2U);
  EXPECT_GT(runs[0].gain, 0.3);
  EXPECT_LT(runs[1].gain, 0.01);
  EXPECT_TRUE(InformativeRuns(MatrixXd::Zero(3, 200), 0, 5).empty());
  EXPECT_TRUE(InformativeRuns(MatrixXd::Zero(3, 1), 0.1, 5).empty());
}

}  // namespace
}  // namespace fourpost::value_of_information_test
