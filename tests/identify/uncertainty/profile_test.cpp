#include "identify/uncertainty/profile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "identify/refine/fit_variables.h"
#include "tests/identify/test_problems.h"

namespace fourpost::profile_test {
namespace {

/// The optimum nearest to `start`, and its covariance.
struct Optimum {
  RefineResult best;
  Covariance covariance;
};

Optimum Find(Archive& archive, const Eigen::VectorXd& start) {
  Optimum optimum{.best = Refine(archive, start)};
  const FitVariables variables(archive.lattice());
  optimum.covariance = EstimateCovariance(optimum.best.jacobian, variables.Slopes(optimum.best.values),
                                          optimum.best.cost, {.inflate = false});
  return optimum;
}

/// Two parameters that only lean on each other's data.
Problem Linear() {
  return {Lattice({{"a", -10, 10, 0.1}, {"b", -10, 10, 0.1}}), [](const Eigen::VectorXd& p) {
            Evaluation evaluation;
            evaluation.residuals.resize(3);
            evaluation.residuals << 3 * p[0] + 2 * p[1] - 1, p[0] - p[1] + 2, 0.5 * p[1] - 3;
            return evaluation;
          }};
}

// A quadratic cost is its own profile, whatever the correlation.
TEST(Profile, OfALinearModelIsItsParabola) {
  Archive archive(Linear(), 1);
  const Optimum optimum = Find(archive, Eigen::Vector2d(5, 5));
  for (Eigen::Index j = 0; j < 2; ++j) {
    const Profile profile = ProfileOf(archive, optimum.best, optimum.covariance, j, {}, {});
    const double value = optimum.best.values[j];
    const double sd = optimum.covariance.sd[j];
    ASSERT_GE(profile.points.size(), 5u);
    for (const ProfilePoint& point : profile.points)
      // The refinement's tolerance of the step.
      EXPECT_NEAR(point.rise, std::pow((point.value - value) / sd, 2), 1e-6 * (1 + point.rise)) << profile.name;
    if (j == 1) continue;
    // Student's t of one degree reaches 12.7 deviations; to a hundredth, as the crossing is looked for.
    const double reach = 12.706 * sd;
    EXPECT_NEAR(profile.lower_95, value - reach, 0.01 * reach);
    EXPECT_NEAR(profile.upper_95, value + reach, 0.01 * reach);
    EXPECT_FALSE(profile.found_better);
  }
}

/// 10 (p^2 - 4): its rise passes 1.96^2 at p = sqrt(4 +- 0.196).
Problem Squared(double lower) {
  return {Lattice({{"p", lower, 3, 0.01}}),
          [](const Eigen::VectorXd& p) { return OneResidual(10 * (p[0] * p[0] - 4)); }};
}

Profile OfSquared(double lower) {
  Archive archive(Squared(lower), 1);
  Optimum optimum = Find(archive, Eigen::VectorXd::Constant(1, 2.5));
  optimum.covariance.reach_95 = 1.96;
  return ProfileOf(archive, optimum.best, optimum.covariance, 0, {}, {});
}

TEST(Profile, IsLopsidedWhereTheModelIs) {
  const Profile profile = OfSquared(0.5);
  const double lower = std::sqrt(4 - 0.196);
  const double upper = std::sqrt(4 + 0.196);
  // A hundredth of either side.
  EXPECT_NEAR(profile.lower_95, lower, 0.01 * (2 - lower));
  EXPECT_NEAR(profile.upper_95, upper, 0.01 * (upper - 2));
  EXPECT_GT(2 - profile.lower_95, 1.01 * (profile.upper_95 - 2));
}

TEST(Profile, IsOpenWhereTheBoundComesFirst) {
  const Profile profile = OfSquared(1.97);
  EXPECT_TRUE(std::isinf(profile.lower_95));
  EXPECT_LT(profile.lower_95, 0);
  EXPECT_DOUBLE_EQ(profile.points.front().value, 1.97);
  EXPECT_TRUE(std::isfinite(profile.upper_95));
}

/// sin(3 p) / 3 + 1.2 has a low of 1.2 - 1/3 every 2 pi / 3, and the slope makes the one on the left the lower.
TEST(Profile, TellsOfABetterOptimum) {
  const Problem two = {Lattice({{"p", -5.36, 3, 0.01}}), [](const Eigen::VectorXd& p) {
                         Evaluation evaluation;
                         evaluation.residuals.resize(2);
                         evaluation.residuals << std::sin(3 * p[0]) / 3 + 1.2, 0.1 * (p[0] + 3);
                         return evaluation;
                       }};
  Archive archive(two, 1);
  // Levenberg-Marquardt would jump out of the low on the right.
  RefineResult best;
  best.values = Eigen::VectorXd::Constant(1, 1.553);
  best.cost = archive.EvaluateValues({best.values}).front().cost();
  Covariance covariance;
  covariance.variable_sd = Eigen::VectorXd::Constant(1, 10);
  covariance.reach_95 = 2;
  // The first step is a quarter of the range, to the other low.
  EXPECT_TRUE(ProfileOf(archive, best, covariance, 0, {}, {}).found_better);
}

TEST(Profile, EndsWhenAsked) {
  Archive archive(Linear(), 1);
  const Optimum optimum = Find(archive, Eigen::Vector2d(5, 5));
  const Profile profile = ProfileOf(archive, optimum.best, optimum.covariance, 0, {}, [] { return true; });
  EXPECT_TRUE(profile.interrupted);
  EXPECT_TRUE(std::isinf(profile.lower_95));
}

}  // namespace
}  // namespace fourpost::profile_test
