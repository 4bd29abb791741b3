#include "identify/suggest/score_test.h"

#include <cmath>

#include <gmock/gmock.h>
#include <Eigen/QR>

#include "analysis/signals/random_stream.h"

namespace fourpost::score_test_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd White(Index count, std::uint64_t seed) {
  RandomStream draws(seed, "noise");
  VectorXd noise(count);
  for (double& value : noise) value = draws.Normal();
  return noise;
}

/// A linear model at its optimum: residuals are noise and something that is missing, less what the columns explain.
FittedPoint Optimum(Index count, Index variables, const VectorXd& missing, std::uint64_t seed) {
  FittedPoint point;
  point.jacobian.resize(count, variables);
  for (Index j = 0; j < variables; ++j)
    point.jacobian.col(j) = White(count, seed + 100 + static_cast<std::uint64_t>(j));
  const VectorXd all = White(count, seed) + missing;
  point.residuals = all - point.jacobian * point.jacobian.colPivHouseholderQr().solve(all);
  return point;
}

/// What is left of a vector when the columns of a matrix are taken out.
VectorXd Beyond(const MatrixXd& matrix, const VectorXd& vector) {
  return vector - matrix * matrix.colPivHouseholderQr().solve(vector);
}

// Of a linear model the cost falls by (q'r)^2 / q'q at -q'r / q'q, q: the new column beyond the others (Rao 1948). The
// grid of amounts resolves 1/300 of its reach, which costs 1e-4 of the fall; ties of variables to their values take as
// much.
TEST(ScoreTest, OfALinearModelIsTheClosedForm) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, -0.6 * column, 1);
  const VectorXd q = Beyond(point.jacobian, column);
  const double amount = -q.dot(point.residuals) / q.squaredNorm();
  const double fall = std::pow(q.dot(point.residuals), 2) / q.squaredNorm();
  ASSERT_GT(amount, 0.4);
  const FollowedCost fitted(point);
  const auto residuals = [&](double s, const VectorXd& step) {
    return std::optional<VectorXd>(point.residuals + s * column + point.jacobian * step);
  };
  const AmountRange range{.first = 0.05, .least = 0, .greatest = 10};
  auto test = TestAmount(fitted, range, residuals);
  ASSERT_TRUE(test.has_value());
  EXPECT_NEAR(test->amount, amount, 0.02 * amount);
  EXPECT_NEAR(point.residuals.squaredNorm() - test->cost, fall, 1e-3 * fall);
  Confirm(fitted, range, residuals, *test);
  EXPECT_TRUE(test->is_confirmed);
  EXPECT_NEAR(test->amount, amount, 1e-3 * amount);
  EXPECT_NEAR(point.residuals.squaredNorm() - test->cost, fall, 1e-4 * fall);
}

// Of a linear model residuals to first order are all there is, so that evaluations find the same; both by the grid of
// amounts.
TEST(ScoreTest, ToFirstOrderIsTheSameOfALinearModel) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, -0.6 * column, 1);
  const FollowedCost fitted(point);
  const AmountRange range{.first = 0.05, .least = 0, .greatest = 10};
  const auto evaluated = TestAmount(
      fitted, range, [&](double s, const VectorXd&) { return std::optional<VectorXd>(point.residuals + s * column); });
  const ScoreTest test = TestToFirstOrder(fitted, range, point.residuals + range.first * column);
  const double fall = point.residuals.squaredNorm() - evaluated->cost;
  ASSERT_GT(fall, 100);
  EXPECT_EQ(test.evaluations, 0);
  EXPECT_NEAR(test.amount, evaluated->amount, 0.05 * evaluated->amount);
  EXPECT_NEAR(test.cost, evaluated->cost, 5e-3 * fall);
}

// It promises something to first order, and every evaluation denies it.
TEST(ScoreTest, WhatEvaluationsRefuteMovesNothing) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, -0.6 * column, 1);
  const FollowedCost fitted(point);
  const auto residuals = [&](double s, const VectorXd& step) {
    const VectorXd worse = step.isZero(0) ? VectorXd::Zero(400) : VectorXd::Ones(400);
    return std::optional<VectorXd>(point.residuals + s * column + point.jacobian * step + worse);
  };
  const AmountRange range{.first = 0.05, .least = 0, .greatest = 10};
  auto test = TestAmount(fitted, range, residuals);
  ASSERT_TRUE(test.has_value());
  EXPECT_FALSE(test->is_confirmed);
  EXPECT_LT(test->cost, 0.9 * point.residuals.squaredNorm());
  Confirm(fitted, range, residuals, *test);
  EXPECT_FALSE(test->is_confirmed);
  EXPECT_EQ(test->cost, point.residuals.squaredNorm());
  EXPECT_EQ(test->step, VectorXd::Zero(5));
  EXPECT_EQ(test->left, point.residuals);
}

TEST(ScoreTest, IsZeroWhereTheSignIsNotPhysical) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, 0.6 * column, 1);
  const auto residuals = [&](double s, const VectorXd& step) {
    return std::optional<VectorXd>(point.residuals + s * column + point.jacobian * step);
  };
  const auto test = TestAmount(FollowedCost(point), {.first = 0.05, .least = 0, .greatest = 10}, residuals);
  ASSERT_TRUE(test.has_value());
  EXPECT_GE(test->cost, point.residuals.squaredNorm() * (1 - 1e-6));
}

// One evaluation shows that nothing is to be had.
TEST(ScoreTest, EndsEarlyWhereNothingIsPromised) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, VectorXd::Zero(400), 1);
  const auto residuals = [&](double s, const VectorXd& step) {
    return std::optional<VectorXd>(point.residuals + s * column + point.jacobian * step);
  };
  const double cost = point.residuals.squaredNorm();
  const AmountRange range{.first = 0.3, .least = -10, .greatest = 10};
  const auto whole = TestAmount(FollowedCost(point), range, residuals);
  const auto ended = TestAmount(FollowedCost(point), range, residuals, LeastPromise(cost, 400, 100));
  ASSERT_TRUE(whole.has_value() && ended.has_value());
  EXPECT_GT(whole->evaluations, 1);
  EXPECT_EQ(ended->evaluations, 1);
  // It could not have been worth adding.
  EXPECT_GT(CriterionChange(cost, whole->cost, 400, 400, 1, 100), 0);
}

TEST(ScoreTest, PromiseIsHalfOfTheLeastThatCanPay) {
  for (const double cost : {100.0, 400.0, 4000.0}) {
    const double promise = LeastPromise(cost, 400, 100);
    EXPECT_GT(CriterionChange(cost, cost - promise, 400, 400, 0, 100), 0);
    EXPECT_LT(CriterionChange(cost, cost - 2.1 * promise, 400, 400, 0, 100), 0);
  }
}

// One of m^2 pairs.
TEST(ScoreTest, EachChoiceIsOneOfAllAdditions) {
  const double one = CriterionChange(500, 400, 400, 400, 1, 100);
  EXPECT_NEAR(CriterionChange(500, 400, 400, 400, 1, 100, 2), one + 2 * std::log(100), 1e-9);
}

// A knee acts from 0.3 on: the slope at 0 says nothing of it.
TEST(ScoreTest, FindsWhatBeginsToActAtSomeAmount) {
  const VectorXd column = White(400, 7);
  const FittedPoint point = Optimum(400, 5, -0.5 * column, 1);
  const auto residuals = [&](double s, const VectorXd& step) {
    return std::optional<VectorXd>(point.residuals + std::max(0.0, s - 0.3) * column + point.jacobian * step);
  };
  const auto test = TestAmount(FollowedCost(point), {.first = 0.5, .least = 0, .greatest = 10}, residuals);
  ASSERT_TRUE(test.has_value());
  EXPECT_NEAR(test->amount, 0.8, 0.1);
}

// 500 sets of white noise, 30 columns that have nothing to do with it each: at most one set in 20 has one that seems
// worth adding.
TEST(ScoreTest, OfWhiteNoiseSuggestsNothing) {
  constexpr int kSets = 500;
  constexpr std::size_t kColumns = 30;
  int worthwhile = 0;
  for (int set = 0; set < kSets; ++set) {
    const auto seed = static_cast<std::uint64_t>(1000 + 50 * set);
    const FittedPoint point = Optimum(300, 4, VectorXd::Zero(300), seed);
    ResidualStructure structure;
    structure.series.push_back({.first = 0, .count = 300, .step = 1});
    const double effective = EffectiveResiduals(point.residuals, structure);
    const double cost = point.residuals.squaredNorm();
    double best = 0;
    for (std::size_t k = 0; k < kColumns; ++k) {
      const VectorXd q = Beyond(point.jacobian, White(300, seed + 7 * k + 900000));
      const double fall = std::pow(q.dot(point.residuals), 2) / q.squaredNorm();
      best = std::min(best, CriterionChange(cost, cost - fall, 300, effective, 1, kColumns));
    }
    worthwhile += best < 0 ? 1 : 0;
  }
  EXPECT_LE(worthwhile, kSets / 20);
}

// The same of additions of several numbers each, all of which are fitted: the best of so many has more to choose from.
TEST(ScoreTest, OfWhiteNoiseSuggestsNoneOfSeveralNumbers) {
  constexpr int kSets = 300;
  constexpr std::size_t kAdditions = 30;
  for (const int numbers : {2, 5}) {
    int worthwhile = 0;
    for (int set = 0; set < kSets; ++set) {
      const auto seed = static_cast<std::uint64_t>(5000 + 500 * set);
      const FittedPoint point = Optimum(120, 4, VectorXd::Zero(120), seed);
      const double cost = point.residuals.squaredNorm();
      double best = 0;
      for (std::size_t k = 0; k < kAdditions; ++k) {
        MatrixXd columns(120, numbers);
        for (int j = 0; j < numbers; ++j)
          columns.col(j) = Beyond(point.jacobian, White(120, seed + 10 * k + static_cast<std::uint64_t>(j) + 700000));
        const double left = Beyond(columns, point.residuals).squaredNorm();
        best = std::min(best, CriterionChange(cost, left, 120, 120, numbers, kAdditions));
      }
      worthwhile += best < 0 ? 1 : 0;
    }
    EXPECT_LE(worthwhile, kSets / 20) << numbers;
  }
}

// Of x_t = a x_{t-1} + e_t a mean is worth n (1 - a) / (1 + a) samples. The correlation is known to 1/sqrt(n).
TEST(EffectiveResiduals, AreThoseOfAnAutoregression) {
  constexpr Index kSamples = 20000;
  constexpr double kCorrelation = 0.8;
  VectorXd noise = White(kSamples, 3);
  ResidualStructure structure;
  structure.series.push_back({.first = 0, .count = kSamples, .step = 1});
  EXPECT_NEAR(EffectiveResiduals(noise, structure), kSamples, 0.05 * kSamples);
  for (Index i = 1; i < kSamples; ++i) noise[i] += kCorrelation * noise[i - 1];
  EXPECT_NEAR(EffectiveResiduals(noise, structure), kSamples / 9.0, 0.05 * kSamples / 9);
}

// Samples that were not measured have residuals of 0.
TEST(EffectiveResiduals, LeaveOutSamplesThatWereNotMeasured) {
  constexpr Index kSamples = 20000;
  ResidualStructure structure;
  structure.series.push_back({.first = 0, .count = kSamples, .step = 1, .unmeasured = 8000});
  VectorXd noise = White(kSamples, 3);
  noise.segment(5000, 8000).setZero();
  EXPECT_NEAR(EffectiveResiduals(noise, structure), 12000, 0.05 * 12000);
  // A series of which nothing was measured.
  structure.series[0].unmeasured = kSamples;
  EXPECT_EQ(EffectiveResiduals(VectorXd::Zero(kSamples), structure), 4);
}

// As AreThoseOfAnAutoregression, of which every fifth sample was not measured.
TEST(EffectiveResiduals, KnowTheCorrelationAcrossGaps) {
  constexpr Index kSamples = 20000;
  constexpr double kCorrelation = 0.8;
  VectorXd noise = White(kSamples, 3);
  for (Index i = 1; i < kSamples; ++i) noise[i] += kCorrelation * noise[i - 1];
  for (Index i = 0; i < kSamples; i += 5) noise[i] = 0;
  ResidualStructure structure;
  structure.series.push_back({.first = 0, .count = kSamples, .step = 1, .unmeasured = kSamples / 5});
  EXPECT_NEAR(EffectiveResiduals(noise, structure), 0.8 * kSamples / 9, 0.07 * 0.8 * kSamples / 9);
}

TEST(CriterionChange, IsThatOfChenAndChen) {
  EXPECT_DOUBLE_EQ(CriterionChange(100, 50, 100, 80, 2, 30),
                   80 * std::log(0.5) + 2 * std::log(80.0) + 2 * std::log(30.0));
  EXPECT_GT(CriterionChange(100, 99, 100, 80, 1, 30), 0);
}

// There are as many models with one more addition as there are additions, whatever each consists of.
TEST(CriterionChange, ChargesTheChoiceAmongModelsOnce) {
  for (const int numbers : {0, 1, 5})
    EXPECT_NEAR(CriterionChange(100, 50, 100, 80, numbers, 60) - CriterionChange(100, 50, 100, 80, numbers, 30),
                2 * std::log(2.0), 1e-12);  // rounding
}

// A cost of 13 for 100 residuals: they are smaller than stated, and a pattern among them is nothing that is missing.
TEST(CriterionChange, AsksForNothingWithinTheStatedErrors) {
  EXPECT_LT(CriterionChange(200, 100, 100, 80, 1, 30), 0);
  EXPECT_GT(CriterionChange(13, 6.5, 100, 80, 1, 30), 0);
}

}  // namespace
}  // namespace fourpost::score_test_test
