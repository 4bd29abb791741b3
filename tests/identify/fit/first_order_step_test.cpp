#include "identify/fit/first_order_step.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/fit/fit.h"
#include "tests/identify/toy_objective.h"

namespace fourpost::first_order_step_test {
namespace {

using Residuals = std::function<Eigen::VectorXd(const std::vector<double>&)>;

constexpr Eigen::Index kCount = 50;

Eigen::VectorXd Input() {
  return Eigen::VectorXd::NullaryExpr(kCount,
                                      [](Eigen::Index k) { return 1 + std::cos(0.3 * static_cast<double>(k)); });
}

/// y = 2 u, integrated with an error of one per cent.
Eigen::VectorXd Coarse(double p) { return (1.01 * p - 2) * Input(); }

/// Noise, 1e-4 of the input.
Eigen::VectorXd Ripple() {
  return Eigen::VectorXd::NullaryExpr(kCount,
                                      [](Eigen::Index k) { return 2e-4 * std::sin(2.7 * static_cast<double>(k * k)); });
}

FitResult Fitted(const Residuals& residuals, const Residuals& finer, int iterations = 100,
                 const std::vector<Eigen::Index>& profiled = {}) {
  const VehicleObjective toy = ToyObjective(1, kCount, 1e-15, {});
  ResidualBlock block{.name = "toy", .count = kCount, .accuracy = 1e-15};
  block.evaluate = [=](const std::vector<double>& values, const Deadline&) {
    return Evaluation{.residuals = residuals(values)};
  };
  block.at_finer_steps = finer;
  FitOptions options;
  options.stop.max_evaluations = 10;
  options.starts = 0;
  options.threads = 1;
  options.refine.max_iterations = iterations;
  options.profiled = profiled;
  return Fit(VehicleObjective(toy.vehicle(), toy.free(), {block}), options);
}

TEST(IntegrationStep, TakesTheFitToWhereAnExactIntegrationHasIt) {
  const FitResult fit = Fitted([](const auto& p) { return Coarse(p[0]); },
                               [](const auto& p) -> Eigen::VectorXd { return (p[0] - 2) * Input(); });
  ASSERT_EQ(fit.end, FitEnd::kConverged) << fit.message;
  // The coarse optimum is 1 % low; what first order leaves is some 1e-4 of it.
  EXPECT_NEAR(fit.parameters[0].value, 2, 4e-4);
  // Intervals rest on residuals of the exact integration, which that leaves: (4e-4 / 0.02)^2 of the coarse ones.
  EXPECT_LT(fit.data_squares, 4e-4 * Coarse(2).squaredNorm());
}

// The coarse optimum is 1 % low, a hundred times what the interval reaches.
TEST(IntegrationStep, HasAProfileAboutTheOptimumOfAnExactIntegration) {
  const FitResult fit =
      Fitted([](const auto& p) -> Eigen::VectorXd { return Coarse(p[0]) + Ripple(); },
             [](const auto& p) -> Eigen::VectorXd { return (p[0] - 2) * Input() + Ripple(); }, 100, {0});
  ASSERT_EQ(fit.profiles.size(), 1U);
  EXPECT_FALSE(fit.profiles[0].found_better);
  EXPECT_LT(fit.profiles[0].lower_95, 2);
  EXPECT_GT(fit.profiles[0].upper_95, 2);
  EXPECT_NEAR(fit.profiles[0].upper_95 - fit.profiles[0].lower_95, 4 * fit.parameters[0].sd,
              0.1 * fit.parameters[0].sd);
}

// Residuals that ask for 5 % more and are far worse there.
TEST(IntegrationStep, IsNotTakenWhereItMakesTheFitWorse) {
  const FitResult fit =
      Fitted([](const auto& p) { return Coarse(p[0]); },
             [](const auto& p) -> Eigen::VectorXd { return Coarse(p[0]) + (p[0] < 1.99 ? -0.1 : 10.0) * Input(); });
  EXPECT_NEAR(fit.parameters[0].value, 2 / 1.01, 1e-6);
}

// One step from afar, in the logarithm of p.
TEST(RemainingStep, LeavesNoDeviationsFarFromTheOptimum) {
  const auto cubic = [](const std::vector<double>& p) -> Eigen::VectorXd { return (std::pow(p[0], 3) - 27) * Input(); };
  const FitResult ended = Fitted(cubic, {}, 1);
  EXPECT_EQ(ended.end, FitEnd::kNotConverged);
  EXPECT_FALSE(ended.covariance);
  EXPECT_EQ(ended.parameters[0].state, ParameterState::kNotComputed);
  EXPECT_TRUE(Fitted(cubic, {}).covariance);
}

}  // namespace
}  // namespace fourpost::first_order_step_test
