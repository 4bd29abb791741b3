#include "identify/refine/refine.h"

#include <cmath>

#include <gtest/gtest.h>

#include "identify/refine/fit_variables.h"

namespace fourpost::far_start_test {
namespace {

// The difference of two decays, with errors that no parameter explains, so that the cost at the optimum is not
// zero.
Evaluation TwoDecays(const Eigen::VectorXd& p) {
  Evaluation evaluation;
  evaluation.residuals.resize(60);
  for (int i = 0; i < 60; ++i) {
    const double t = 0.05 * i;
    const double data = 2 * std::exp(-1.5 * t) - 3 * std::exp(-6 * t) + 0.01 * std::sin(37.0 * i * i);
    evaluation.residuals[i] = 100 * (p[0] * std::exp(-p[1] * t) - p[2] * std::exp(-p[3] * t) - data);
  }
  return evaluation;
}

Problem FarProblem() {
  return {Lattice({{"a", 0.1, 10, 0.1}, {"k", 0.1, 4, 0.1}, {"b", 0.1, 10, 0.1}, {"l", 4, 40, 0.1}}), TwoDecays};
}

RefineResult FromFar(const Problem& problem, Differences differences) {
  Archive archive(problem, 1);
  return Refine(archive, Eigen::Vector4d(0.3, 0.3, 8, 30), {.differences = differences, .nearness = 0.1});
}

TEST(FarStart, IsLeftByForwardDifferencesForLess) {
  const RefineResult central = FromFar(FarProblem(), Differences::kCentral);
  const RefineResult automatic = FromFar(FarProblem(), Differences::kAutomatic);
  ASSERT_EQ(central.end, RefineEnd::kConverged);
  ASSERT_EQ(automatic.end, RefineEnd::kConverged);
  // Both end within a tenth of a deviation, by `nearness`: 0.01 of the cost over 56 degrees of freedom.
  EXPECT_NEAR(automatic.cost, central.cost, 0.02 * central.cost / 56);
  EXPECT_LT(automatic.evaluations, 0.8 * static_cast<double>(central.evaluations));
}

TEST(FarStart, EndsWithCentralDifferences) {
  const Problem problem = FarProblem();
  const RefineResult result = FromFar(problem, Differences::kAutomatic);
  Archive archive(problem, 1);
  const FitVariables variables(archive.lattice());
  const std::optional<Eigen::MatrixXd> central =
      DifferenceJacobian(archive, variables, variables.FromValues(result.values), result.residuals,
                         StepFor(problem.accuracy, Differences::kCentral), Differences::kCentral);
  ASSERT_TRUE(central.has_value());
  // To rounding of the values on their way into variables and back, over the step.
  EXPECT_LT((result.jacobian - *central).norm(), 1e-8 * central->norm());
}

}  // namespace
}  // namespace fourpost::far_start_test
