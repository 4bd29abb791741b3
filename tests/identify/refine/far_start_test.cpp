#include "identify/refine/refine.h"

#include <cmath>

#include <gtest/gtest.h>

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

// A valley narrower than a forward difference is long: from its left side the bottom lies within the step, the slope
// seems to rise, and no step to the left is taken.
Problem ValleyProblem() {
  Problem problem{Lattice({{"x", 0, 1, 0.01}}), [](const Eigen::VectorXd& p) {
                    Evaluation evaluation;
                    evaluation.residuals.resize(40);
                    for (int i = 0; i < 40; ++i)
                      evaluation.residuals[i] = (i % 2 == 0 ? 3 : -3) + 400 * std::hypot(p[0] - 0.5, 1e-4);
                    return evaluation;
                  }};
  problem.accuracy = 1e-4;
  return problem;
}

TEST(FarStart, EndsWhereCentralDifferencesDo) {
  const auto cost_by = [](Differences differences) {
    Archive archive(ValleyProblem(), 1);
    return Refine(archive, Eigen::VectorXd::Constant(1, 0.496), {.differences = differences, .nearness = 0.1}).cost;
  };
  // 462 at the start, 360 at the bottom.
  EXPECT_LT(cost_by(Differences::kCentral), 365);
  EXPECT_DOUBLE_EQ(cost_by(Differences::kAutomatic), cost_by(Differences::kCentral));
}

}  // namespace
}  // namespace fourpost::far_start_test
