#include "identify/suggest/new_numbers.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "analysis/signals/random_stream.h"

namespace fourpost::new_numbers_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kCount = 400;

MatrixXd White(Index columns, std::uint64_t seed) {
  RandomStream draws(seed, "noise");
  MatrixXd noise(kCount, columns);
  for (double& value : noise.reshaped()) value = draws.Normal();
  return noise;
}

VectorXd Beyond(const MatrixXd& matrix, const VectorXd& vector) {
  return vector - matrix * matrix.colPivHouseholderQr().solve(vector);
}

/// A linear model of five variables at its optimum, which lacks 0.5 and -0.2 of two columns.
class TwoNumbers : public testing::Test {
 protected:
  TwoNumbers() {
    point_.jacobian = White(5, 1);
    const VectorXd all = White(1, 2) - columns_ * Eigen::Vector2d(0.5, -0.2);
    point_.residuals = Beyond(point_.jacobian, all);
  }

  std::optional<VectorXd> At(const VectorXd& numbers, const VectorXd& step) const {
    return VectorXd(point_.residuals + columns_ * numbers + point_.jacobian * step);
  }

  /// The amount ties both numbers together.
  ScoreTest Confirmed(const FollowedCost& fitted) const {
    const AmountRange range{.first = 0.05, .least = 0, .greatest = 1};
    const auto residuals = [&](double amount, const VectorXd& step) { return At(VectorXd::Constant(2, amount), step); };
    auto test = TestAmount(fitted, range, residuals);
    Confirm(fitted, range, residuals, *test);
    EXPECT_TRUE(test->is_confirmed);
    return *test;
  }

  NewNumbers Numbers(const ScoreTest& test, double least) const {
    return {.first = VectorXd::Constant(2, test.amount),
            .lower = VectorXd::Constant(2, least),
            .upper = VectorXd::Constant(2, 1),
            .residuals = [this](const VectorXd& numbers, const VectorXd& step) { return At(numbers, step); }};
  }

  const MatrixXd columns_ = White(2, 3);
  FittedPoint point_;
};

// All numbers of a linear model are those of least squares, and so is the cost. Ties of the variables to their values
// take 1e-4 of the fall.
TEST_F(TwoNumbers, GoTheirOwnWays) {
  MatrixXd all(kCount, 7);
  all << point_.jacobian, columns_;
  const double least = Beyond(all, point_.residuals).squaredNorm();
  const FollowedCost fitted(point_);
  ScoreTest test = Confirmed(fitted);
  const double tied = test.cost;
  const VectorXd numbers = FitNumbers(fitted, Numbers(test, -1), test);
  EXPECT_GT(tied - least, 0.3 * (point_.residuals.squaredNorm() - least));
  EXPECT_NEAR(test.cost, least, 1e-4 * (tied - least));
  const VectorXd exact = -all.colPivHouseholderQr().solve(point_.residuals).tail(2);
  EXPECT_LT((numbers - exact).norm(), 1e-3 * exact.norm());
  EXPECT_DOUBLE_EQ(test.left.squaredNorm(), test.cost);
  EXPECT_LT((test.left - *At(numbers, test.step)).norm(), 1e-12);  // rounding
}

// The second would be negative: without it the first is that of least squares alone.
TEST_F(TwoNumbers, StayWithinTheirBounds) {
  MatrixXd first(kCount, 6);
  first << point_.jacobian, columns_.col(0);
  const FollowedCost fitted(point_);
  ScoreTest test = Confirmed(fitted);
  const VectorXd numbers = FitNumbers(fitted, Numbers(test, 0), test);
  EXPECT_EQ(numbers[1], 0);
  EXPECT_NEAR(test.cost, Beyond(first, point_.residuals).squaredNorm(), 1e-3 * test.cost);
}

// A number whose steps cannot be evaluated stays where it is, and no evaluation that fails moves anything.
TEST_F(TwoNumbers, StayWhereNothingCanBeEvaluated) {
  const FollowedCost fitted(point_);
  ScoreTest test = Confirmed(fitted);
  const double cost = test.cost;
  NewNumbers numbers = Numbers(test, -1);
  numbers.residuals = [](const VectorXd&, const VectorXd&) { return std::optional<VectorXd>(); };
  EXPECT_EQ(FitNumbers(fitted, numbers, test), numbers.first);
  EXPECT_EQ(test.cost, cost);
}

}  // namespace
}  // namespace fourpost::new_numbers_test
