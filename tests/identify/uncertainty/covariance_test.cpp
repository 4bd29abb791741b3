#include "identify/uncertainty/covariance.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include "identify/search/draws.h"
#include "tests/rounding.h"

namespace fourpost::covariance_test {
namespace {

using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

// Uniform in [-1, 1).
Eigen::MatrixXd RandomMatrix(Eigen::Index rows, Eigen::Index columns) {
  Draws draws(1, DrawPurpose::kTrial, rows, static_cast<std::size_t>(columns));
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return 2 * draws.Uniform() - 1; });
}

// Sum of 12 uniform numbers: mean 0, variance 1.
double NearlyNormal(Draws& draws) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += draws.Uniform();
  return sum;
}

Eigen::VectorXd Ones(Eigen::Index n) { return Eigen::VectorXd::Ones(n); }

TEST(Covariance, OfFullRankIsTheInverseOfTheNormalMatrix) {
  const Eigen::MatrixXd jacobian = RandomMatrix(30, 4);
  const Eigen::Vector4d slopes(200, 1e4, 0.5, 3);
  const Covariance covariance = EstimateCovariance(jacobian, slopes, 0);
  const Eigen::VectorXd sd = (jacobian.transpose() * jacobian).inverse().diagonal().cwiseSqrt();
  EXPECT_EQ(covariance.rank, 4);
  EXPECT_EQ(covariance.inflation, 1);
  // Rounding times the square of a condition below 10.
  EXPECT_TRUE(covariance.variable_sd.isApprox(sd, 1e-13));
  EXPECT_TRUE(covariance.sd.isApprox(sd.cwiseProduct(slopes), 1e-13));
  EXPECT_EQ(covariance.condition, covariance.determined_condition);
  EXPECT_DOUBLE_EQ(covariance.condition, covariance.singular_values[0] / covariance.singular_values[3]);
}

TEST(Covariance, CorrelationsAreThoseOfTheInverse) {
  const Eigen::MatrixXd jacobian = RandomMatrix(30, 4);
  const Eigen::MatrixXd inverse = (jacobian.transpose() * jacobian).inverse();
  const Eigen::VectorXd scale = inverse.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd expected = scale.asDiagonal() * inverse * scale.asDiagonal();
  // Rounding times the square of a condition below 10.
  EXPECT_TRUE(Correlations(EstimateCovariance(jacobian, Ones(4), 0)).isApprox(expected, 1e-13));
}

TEST(Covariance, UndeterminedParametersHaveNoCorrelation) {
  Eigen::MatrixXd jacobian = RandomMatrix(30, 3);
  jacobian.col(1).setZero();
  const Eigen::MatrixXd correlations = Correlations(EstimateCovariance(jacobian, Ones(3), 0));
  EXPECT_TRUE(std::isnan(correlations(1, 1)));
  EXPECT_TRUE(std::isnan(correlations(0, 1)));
  EXPECT_EQ(correlations(0, 0), 1);
  EXPECT_LT(std::abs(correlations(0, 2)), 1);
}

TEST(Covariance, DirectionsDecomposeTheNormalMatrix) {
  const Eigen::MatrixXd jacobian = RandomMatrix(30, 4);
  const Covariance covariance = EstimateCovariance(jacobian, Ones(4), 0);
  const Eigen::MatrixXd& v = covariance.directions;
  const Eigen::MatrixXd squares = covariance.singular_values.cwiseAbs2().asDiagonal();
  EXPECT_TRUE((v * squares * v.transpose()).isApprox(jacobian.transpose() * jacobian, 1e-13));  // rounding
  for (Eigen::Index i = 0; i < 4; ++i) {
    EXPECT_EQ(v.col(i).maxCoeff(), v.col(i).cwiseAbs().maxCoeff());
  }
  for (Eigen::Index i = 1; i < 4; ++i) EXPECT_LE(covariance.singular_values[i], covariance.singular_values[i - 1]);
}

TEST(Covariance, InflatesByTheExcessOfTheCost) {
  const Eigen::MatrixXd jacobian = RandomMatrix(30, 4);
  const Covariance plain = EstimateCovariance(jacobian, Ones(4), 0);
  // 26 degrees of freedom.
  EXPECT_EQ(EstimateCovariance(jacobian, Ones(4), 26).inflation, 1);
  EXPECT_EQ(EstimateCovariance(jacobian, Ones(4), 13).inflation, 1);
  const Covariance inflated = EstimateCovariance(jacobian, Ones(4), 9 * 26);
  EXPECT_DOUBLE_EQ(inflated.inflation, 3);
  // As of a Jacobian without the rows that say nothing.
  Eigen::MatrixXd longer = Eigen::MatrixXd::Zero(jacobian.rows() + 100, jacobian.cols());
  longer.topRows(jacobian.rows()) = jacobian;
  const Covariance measured = EstimateCovariance(longer, Ones(4), 9 * 26, {.unmeasured = 100});
  EXPECT_DOUBLE_EQ(measured.inflation, 3);
  EXPECT_DOUBLE_EQ(measured.reach_95, inflated.reach_95);
  EXPECT_NEAR(inflated.reach_95, 2.056, 5e-4);             // a table of Student's t
  EXPECT_TRUE(inflated.sd.isApprox(3 * plain.sd, 1e-15));  // rounding
  CovarianceOptions options;
  options.inflate = false;
  EXPECT_EQ(EstimateCovariance(jacobian, Ones(4), 9 * 26, options).sd, plain.sd);
}

TEST(Covariance, IsTheScatterOfLinearFits) {
  const Eigen::MatrixXd jacobian = RandomMatrix(20, 3);
  const Covariance covariance = EstimateCovariance(jacobian, Ones(3), 0);
  const Eigen::MatrixXd solve = (jacobian.transpose() * jacobian).inverse() * jacobian.transpose();
  Draws draws(2, DrawPurpose::kTrial, 0, 0);
  const int fits = 2000;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(3);
  for (int i = 0; i < fits; ++i) {
    squares += (solve * Eigen::VectorXd::NullaryExpr(20, [&] { return NearlyNormal(draws); })).cwiseAbs2();
  }
  for (Eigen::Index j = 0; j < 3; ++j) {
    // 4 standard deviations of a standard deviation from 2000 fits.
    EXPECT_NEAR(std::sqrt(squares[j] / fits) / covariance.sd[j], 1, 4 / std::sqrt(2 * fits));
  }
}

// Residuals that depend on a b, and on c: ln a and ln b cannot be told apart, c can.
TEST(Covariance, FindsAnExactNullDirectionAndWhomItConcerns) {
  Eigen::MatrixXd jacobian = RandomMatrix(30, 3);
  jacobian.col(1) = jacobian.col(0);
  const Covariance covariance = EstimateCovariance(jacobian, Ones(3), 0);
  EXPECT_EQ(covariance.rank, 2);
  EXPECT_EQ(covariance.condition, kInfinity);
  EXPECT_LT(covariance.determined_condition, 10);
  const Eigen::VectorXd null = covariance.directions.col(2);
  EXPECT_NEAR(std::abs(null[0]), std::sqrt(0.5), 1e-14);  // rounding
  EXPECT_NEAR(null[0] + null[1], 0, 1e-14);
  EXPECT_NEAR(null[2], 0, 1e-14);
  EXPECT_EQ(covariance.sd[0], kInfinity);
  EXPECT_EQ(covariance.sd[1], kInfinity);
  // As if b were known.
  Eigen::MatrixXd reduced(30, 2);
  reduced << jacobian.col(0), jacobian.col(2);
  EXPECT_NEAR(covariance.sd[2] / EstimateCovariance(reduced, Ones(2), 0).sd[1], 1, 1e-13);  // rounding
}

TEST(Covariance, CountsFinestSingularValueByTheThreshold) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(5, 3);
  jacobian.diagonal() << 100, 10, 0.2;
  EXPECT_EQ(EstimateCovariance(jacobian, Ones(3), 0).rank, 3);
  CovarianceOptions options;
  options.rank_threshold = 0.01;
  const Covariance covariance = EstimateCovariance(jacobian, Ones(3), 0, options);
  EXPECT_EQ(covariance.rank, 2);
  EXPECT_EQ(covariance.sd, Eigen::Vector3d(0.01, 0.1, kInfinity));
}

// A null direction of (1, share) leaves the second parameter determined only below the threshold.
TEST(Covariance, LeavesAParameterDeterminedWhoseShareOfTheNullDirectionIsNoise) {
  const auto sd = [](double share) {
    Eigen::MatrixXd jacobian(2, 2);
    jacobian << -share, 1, 0, 0;
    return EstimateCovariance(jacobian, Ones(2), 0).sd;
  };
  EXPECT_EQ(sd(0.009)[0], kInfinity);
  EXPECT_TRUE(std::isfinite(sd(0.009)[1]));
  EXPECT_EQ(sd(0.011)[1], kInfinity);
}

TEST(Covariance, OfDataAndPriorsIsTheInverseOfTheSumOfTheirInformation) {
  const Eigen::MatrixXd jacobian = RandomMatrix(30, 4);
  const Eigen::MatrixXd priors = Eigen::RowVector4d(0, 3, 0, 0);
  const Eigen::MatrixXd data = jacobian.transpose() * jacobian;
  const Eigen::MatrixXd known = priors.transpose() * priors;
  const auto sd = [](const Eigen::MatrixXd& information) { return information.inverse().diagonal().cwiseSqrt(); };
  // Rounding times the square of a condition below 10.
  EXPECT_TRUE(EstimateCovariance(jacobian, Ones(4), 0, {}, priors).sd.isApprox(sd(data + known), 1e-13));
  // The data miss the model three times more than their noise; of the prior that says nothing.
  const Covariance inflated = EstimateCovariance(jacobian, Ones(4), 9 * 26, {}, priors);
  EXPECT_DOUBLE_EQ(inflated.inflation, 3);
  EXPECT_TRUE(inflated.sd.isApprox(sd(data / 9 + known), 1e-13));
  EXPECT_LT(inflated.sd[1], 1.0 / 3);
}

TEST(Covariance, APriorDeterminesWhatTheDataLeaveOpenHoweverWeakly) {
  Eigen::MatrixXd jacobian = RandomMatrix(30, 3);
  jacobian.col(1) = jacobian.col(0);
  // Far below the share of the largest singular value that counts for data.
  const Covariance covariance = EstimateCovariance(jacobian, Ones(3), 0, {}, Eigen::RowVector3d(1e-5, 0, 0));
  EXPECT_EQ(covariance.rank, 3);
  // Rounding of the largest singular value over the smallest.
  EXPECT_NEAR(covariance.sd[0] / 1e5, 1, 1e-8);
  EXPECT_NEAR(covariance.sd[1] / 1e5, 1, 1e-8);
  EXPECT_LT(covariance.sd[2], 1);
}

TEST(Covariance, APriorOnWhatTheDataTellLeavesTheRestOpen) {
  Eigen::MatrixXd jacobian(3, 2);
  // The undetermined direction is the first parameter, but for noise.
  jacobian << 1e-4, 1, 0, 0, 0, 0;
  const Covariance covariance = EstimateCovariance(jacobian, Ones(2), 0, {}, Eigen::RowVector2d(0, 100));
  EXPECT_EQ(covariance.rank, 1);
  EXPECT_EQ(covariance.sd[0], kInfinity);
  EXPECT_NEAR(covariance.sd[1], 1 / std::sqrt(1 + 1e4), 1e-9);  // the square of the noise
}

TEST(Covariance, RefusesPriorsOfOtherParameters) {
  const auto estimate = [](const Eigen::MatrixXd& priors) {
    return [=] { EstimateCovariance(RandomMatrix(4, 2), Ones(2), 0, {}, priors); };
  };
  using Error = std::invalid_argument;
  EXPECT_THAT(estimate(Ones(3).transpose()),
              ThrowsMessage<Error>(StrEq("the priors are of 3 parameters, the Jacobian of 2")));
  EXPECT_THAT(estimate(Eigen::RowVector2d(1, std::nan(""))),
              ThrowsMessage<Error>(HasSubstr("priors have an entry that is not finite")));
}

TEST(Covariance, OfFewerResidualsThanParametersHasANullDirection) {
  const Covariance covariance = EstimateCovariance(RandomMatrix(2, 3), Ones(3), 5);
  EXPECT_EQ(covariance.rank, 2);
  EXPECT_EQ(covariance.singular_values.size(), 3);
  EXPECT_EQ(covariance.singular_values[2], 0);
  EXPECT_EQ(covariance.directions.cols(), 3);
  EXPECT_EQ(covariance.inflation, 1);
}

TEST(Covariance, OfAZeroJacobianDeterminesNothing) {
  const Covariance covariance = EstimateCovariance(Eigen::MatrixXd::Zero(4, 2), Ones(2), 1);
  EXPECT_EQ(covariance.rank, 0);
  EXPECT_EQ(covariance.condition, kInfinity);
  EXPECT_EQ(covariance.determined_condition, kInfinity);
  EXPECT_EQ(covariance.sd, Eigen::Vector2d(kInfinity, kInfinity));
}

TEST(Covariance, RefusesWhatIsNoJacobianOfTheseParameters) {
  const Eigen::MatrixXd good = RandomMatrix(4, 2);
  Eigen::MatrixXd bad = good;
  bad(1, 1) = std::nan("");
  const auto estimate = [](const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& slopes, double cost) {
    return [=] { EstimateCovariance(jacobian, slopes, cost); };
  };
  using Error = std::invalid_argument;
  EXPECT_THAT(estimate(bad, Ones(2), 0), ThrowsMessage<Error>(HasSubstr("Jacobian has an entry that is not finite")));
  EXPECT_THAT(estimate(good, Ones(3), 0), ThrowsMessage<Error>(StrEq("the Jacobian is 4 x 2, the slopes are 3")));
  EXPECT_THAT(estimate(Eigen::MatrixXd(), Ones(0), 0), ThrowsMessage<Error>(HasSubstr("0 x 0")));
  EXPECT_THAT(estimate(good, Eigen::Vector2d(1, 0), 0), ThrowsMessage<Error>(HasSubstr("slope")));
  EXPECT_THAT(estimate(good, Ones(2), -1), ThrowsMessage<Error>(StrEq("cost = -1, must be 0 or more")));
  EXPECT_THAT(estimate(good, Ones(2), std::nan("")), ThrowsMessage<Error>(HasSubstr("cost = nan")));
}

TEST(Covariance, RefusesThresholdsOutOfBoundsByName) {
  CovarianceOptions options;
  options.rank_threshold = 0;
  EXPECT_THAT([&] { options.Validate(); },
              ThrowsMessage<std::invalid_argument>(StrEq("rank_threshold = 0, must be in (0, 1)")));
  options = {};
  options.share_threshold = 1;
  EXPECT_THAT([&] { options.Validate(); },
              ThrowsMessage<std::invalid_argument>(StrEq("share_threshold = 1, must be in (0, 1)")));
}

TEST(DescribeDirection, NamesTheStrongestFirstAndLeavesOutTheWeak) {
  const Lattice lattice({{"m", 1, 9, 1}, {"k", 1, 9, 1}, {"d", 1, 9, 1}, {"offset", -1, 1, 0.1}});
  EXPECT_EQ(DescribeDirection(lattice, Eigen::Vector4d(0.49, 0.5, 0.02, 0.26)),
            "k +1 %, m +0.98 %, offset +0.52 % of range");
  EXPECT_EQ(DescribeDirection(lattice, Eigen::Vector4d(0.5, -1, 0, 0)), "k +1 %, m -0.5 %");
  EXPECT_THROW(DescribeDirection(lattice, Eigen::Vector3d(1, 0, 0)), std::invalid_argument);
}

TEST(DescribeDirection, PutsANullDirectionIntoWords) {
  const Lattice lattice({{"a", 1, 9, 1}, {"b", 1, 9, 1}, {"c", 1, 9, 1}});
  Eigen::MatrixXd jacobian = RandomMatrix(30, 3);
  jacobian.col(1) = 0.5 * jacobian.col(0);
  const Covariance covariance = EstimateCovariance(jacobian, Ones(3), 0);
  EXPECT_EQ(DescribeDirection(lattice, covariance.directions.col(2)), "b +1 %, a -0.5 %");
}

TEST(Covariance, HeldParametersTakeNoPart) {
  const Eigen::MatrixXd jacobian = RandomMatrix(40, 4);
  const Eigen::MatrixXd priors = RandomMatrix(2, 4);
  Eigen::MatrixXd rest(40, 3);
  rest << jacobian.col(0), jacobian.col(2), jacobian.col(3);
  Eigen::MatrixXd rest_priors(2, 3);
  rest_priors << priors.col(0), priors.col(2), priors.col(3);
  const Covariance held = EstimateCovariance(jacobian, Ones(4), 50, {.held = {1}}, priors);
  const Covariance without = EstimateCovariance(rest, Ones(3), 50, {}, rest_priors);
  EXPECT_EQ(held.rank, 3);
  EXPECT_EQ(held.singular_values, without.singular_values);
  EXPECT_TRUE(std::isnan(held.sd[1]));
  EXPECT_EQ(held.sd[0], without.sd[0]);
  EXPECT_EQ(held.sd[3], without.sd[2]);
  EXPECT_EQ(held.directions.row(1).norm(), 0);
  EXPECT_EQ(held.directions(2, 0), without.directions(1, 0));
  EXPECT_TRUE(std::isnan(Correlations(held)(1, 0)));
  EXPECT_EQ(Correlations(held)(3, 0), Correlations(without)(2, 0));
}

TEST(Covariance, NothingIsLeftWhereAllAreHeld) {
  const Covariance held = EstimateCovariance(RandomMatrix(9, 2), Ones(2), 36, {.held = {0, 1}});
  EXPECT_EQ(held.rank, 0);
  EXPECT_EQ(held.directions.cols(), 0);
  EXPECT_EQ(held.inflation, 2);
  EXPECT_THAT([] { EstimateCovariance(RandomMatrix(9, 2), Ones(2), 36, {.held = {2}}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("held = 2, must be a place of a parameter")));
}

}  // namespace
}  // namespace fourpost::covariance_test
