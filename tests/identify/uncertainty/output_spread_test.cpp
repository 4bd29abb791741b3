#include "identify/uncertainty/output_spread.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::output_spread_test {
namespace {

/// One relative parameter, one by its range, one that stays.
ParameterSpread Spread() {
  ParameterSpread spread{.lattice = Lattice({{"k", 1, 100, 0.1}, {"held", 1, 9, 0.1}, {"b", -5, 5, 0.1}})};
  spread.values = Eigen::Vector3d(20, 3, 1);
  spread.judged = {0, 2};
  spread.noise = spread.total = Eigen::Matrix2d::Identity();
  spread.total << 4e-4, 1e-4, 1e-4, 1e-4;
  return spread;
}

// y = k^2 b: dy/dln k = 2 k^2 b = 800, dy/dshare = k^2 10 = 4000.
TEST(OutputSpread, IsThatOfTheDerivatives) {
  int evaluations = 0;
  const auto outputs = [&](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    ++evaluations;
    EXPECT_EQ(p[1], 3);
    return Eigen::VectorXd::Constant(1, p[0] * p[0] * p[2]);
  };
  const Eigen::MatrixXd jacobian = OutputJacobian(Spread(), 1, outputs);
  EXPECT_EQ(evaluations, 4);
  EXPECT_NEAR(jacobian(0, 0), 800, 0.1);
  EXPECT_NEAR(jacobian(0, 1), 4000, 0.1);
  const double variance = 800 * 800 * 4e-4 + 4000.0 * 4000 * 1e-4 + 2 * 800 * 4000.0 * 1e-4;
  EXPECT_NEAR(OutputVariances(jacobian, Spread().total)[0], variance, 1e-3 * variance);
}

TEST(OutputSpread, IsOneSidedAtABoundAndZeroWhereTheModelFails) {
  ParameterSpread spread = Spread();
  spread.values[0] = 1;
  const auto outputs = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    if (p[2] > 1) return {};
    return Eigen::VectorXd::Constant(1, p[0]);
  };
  const Eigen::MatrixXd jacobian = OutputJacobian(spread, 1, outputs);
  EXPECT_NEAR(jacobian(0, 0), 1, 0.01);
  EXPECT_EQ(jacobian(0, 1), 0);
}

/// As OutputSpread.IsThatOfTheDerivatives, and a second output that turns round at the fitted values.
Eigen::VectorXd Kinked(const Eigen::VectorXd& p) {
  return Eigen::Vector2d(p[0] * p[0] * p[2], 1e4 * std::abs(p[0] - 20));
}

TEST(OutputSpread, AcceptsDerivativesThatDifferencesConfirm) {
  int evaluations = 0;
  const auto outputs = [&](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    ++evaluations;
    return Eigen::VectorXd::Constant(1, p[0] * p[0] * p[2]);
  };
  EXPECT_TRUE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(800, 4000), outputs));
  EXPECT_EQ(evaluations, 4);
  EXPECT_TRUE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(800, 4100), outputs));
}

TEST(OutputSpread, RefusesDerivativesThatDifferencesDeny) {
  const auto outputs = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, p[0] * p[0] * p[2]);
  };
  EXPECT_FALSE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(800, 4500), outputs));
  EXPECT_FALSE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(-800, 4000), outputs));
  EXPECT_FALSE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(std::nan(""), 4000), outputs));
  // One-sided at a kink.
  Eigen::Matrix2d one_sided;
  one_sided << 800, 4000, 2e5, 0;
  EXPECT_FALSE(OutputDerivativesHold(Spread(), one_sided, Kinked));
  EXPECT_FALSE(OutputDerivativesHold(Spread(), Eigen::RowVector2d(800, 4000),
                                     [](const Eigen::VectorXd&) { return Eigen::VectorXd(); }));
}

// There is no room for central differences: what is one-sided there would go unseen.
TEST(OutputSpread, RefusesDerivativesNextToABound) {
  ParameterSpread spread = Spread();
  spread.values[0] = 1.0005;
  const auto outputs = [](const Eigen::VectorXd& p) -> Eigen::VectorXd { return Eigen::VectorXd::Constant(1, p[0]); };
  EXPECT_FALSE(OutputDerivativesHold(spread, Eigen::RowVector2d(1.0005, 0), outputs));
  spread.values[0] = 20;
  EXPECT_TRUE(OutputDerivativesHold(spread, Eigen::RowVector2d(20, 0), outputs));
}

TEST(OutputSpread, SlopesAreThoseOfTheFitVariables) {
  const Eigen::VectorXd slopes = JudgedSlopes(Spread());
  EXPECT_EQ(slopes, Eigen::Vector2d(20, 10));
}

}  // namespace
}  // namespace fourpost::output_spread_test
