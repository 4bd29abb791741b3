// Designs against those that are known, and against all that there are.
#include "identify/plan/experiment_design.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "analysis/signals/random_stream.h"

namespace fourpost::experiment_design_test {
namespace {

using Eigen::Index;

/// y = a + b x + c x^2 .. at x, one unit of noise; as many coefficients as there are.
PossibleRun At(double x, Index coefficients, double cost_s = 1, int most = 100) {
  PossibleRun run{.cost_s = cost_s, .most_repeats = most};
  run.slopes.resize(1, coefficients);
  for (Index k = 0; k < coefficients; ++k) run.slopes(0, k) = std::pow(x, static_cast<double>(k));
  run.noise = Eigen::VectorXd::Ones(1);
  run.floor = Eigen::VectorXd::Zero(1);
  return run;
}

Eigen::MatrixXd Weak(Index p) { return 1e-6 * Eigen::MatrixXd::Identity(p, p); }

/// Geometric mean of standard deviations, up to a factor of the correlations: the root of the determinant.
double SizeOf(const Eigen::MatrixXd& covariance) {
  return std::pow(covariance.determinant(), 0.5 / static_cast<double>(covariance.rows()));
}

// A straight line is measured at its ends, a parabola at its ends and its middle, all as often (Fedorov 1972).
TEST(ExperimentDesign, IsTheKnownOneForPolynomials) {
  const std::vector<double> places = {-1, -0.5, 0, 0.5, 1};
  for (const Index coefficients : {2, 3}) {
    std::vector<PossibleRun> runs;
    for (const double x : places) runs.push_back(At(x, coefficients));
    const ExperimentDesign design = BestDesign(Weak(coefficients), runs, {.budget_s = 12});
    const std::vector<int> line = {6, 0, 0, 0, 6};
    const std::vector<int> parabola = {4, 0, 4, 0, 4};
    EXPECT_EQ(design.repeats, coefficients == 2 ? line : parabola);
    EXPECT_EQ(design.cost_s, 12);
    // It is the best of parts too, so that the certificate says so, to the end of its iteration.
    ASSERT_TRUE(design.efficiency.has_value());
    EXPECT_NEAR(*design.efficiency, 1, 1e-3);
  }
}

/// Three parameters, six runs of eight readings each, of which some have errors that stay.
std::vector<PossibleRun> RandomRuns(std::uint64_t seed) {
  RandomStream draws(seed, "runs");
  std::vector<PossibleRun> runs;
  for (int c = 0; c < 6; ++c) {
    PossibleRun run{.cost_s = 1 + 3 * draws.Uniform(), .most_repeats = 3};
    run.slopes.resize(8, 3);
    for (double& slope : run.slopes.reshaped()) slope = draws.Normal();
    run.noise = Eigen::VectorXd::Constant(8, 1);
    run.floor = Eigen::VectorXd::Constant(8, c % 2 == 0 ? 0.3 : 0);
    runs.push_back(std::move(run));
  }
  return runs;
}

/// All repeats that a budget affords.
template <typename Visit>
void ForEachDesign(const std::vector<PossibleRun>& runs, double budget_s, Visit visit) {
  std::vector<int> repeats(runs.size());
  while (true) {
    double cost = 0;
    for (std::size_t c = 0; c < runs.size(); ++c) cost += runs[c].cost_s * repeats[c];
    if (cost <= budget_s) visit(repeats, cost);
    std::size_t c = 0;
    while (c < runs.size() && repeats[c] == runs[c].most_repeats) repeats[c++] = 0;
    if (c == runs.size()) return;
    ++repeats[c];
  }
}

TEST(ExperimentDesign, NoOtherIsBetterThanItsCertificateSays) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const std::vector<PossibleRun> runs = RandomRuns(seed);
    const double budget_s = 9;
    const ExperimentDesign design = BestDesign(Weak(3), runs, {.budget_s = budget_s});
    double least = std::numeric_limits<double>::infinity();
    ForEachDesign(runs, budget_s, [&](const std::vector<int>& repeats, double) {
      least = std::min(least, SizeOf(CovarianceWith(Weak(3), runs, repeats)));
    });
    EXPECT_LE(design.cost_s, budget_s);
    const double own = SizeOf(design.covariance);
    EXPECT_NEAR(own, SizeOf(CovarianceWith(Weak(3), runs, design.repeats)), 1e-9 * own);
    EXPECT_GE(least / own, *design.efficiency * (1 - 1e-9)) << seed;
    // Whole repeats of six runs: adding and exchanging ends within a tenth of the best.
    EXPECT_GT(least / own, 0.9) << seed;
    EXPECT_GT(*design.efficiency, 0.75) << seed;
  }
}

TEST(ExperimentDesign, MeetsTargetsInLittleTime) {
  constexpr std::uint64_t kSeeds = 30;
  double ratios = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::vector<PossibleRun> runs = RandomRuns(seed);
    const DesignGoal goal{.budget_s = 20, .targets = Eigen::Vector3d(0.4, 1e300, 0.3)};
    const ExperimentDesign design = BestDesign(Weak(3), runs, goal);
    double least_s = std::numeric_limits<double>::infinity();
    ForEachDesign(runs, goal.budget_s, [&](const std::vector<int>& repeats, double cost_s) {
      const Eigen::VectorXd deviations = CovarianceWith(Weak(3), runs, repeats).diagonal().cwiseSqrt();
      if ((deviations.array() <= goal.targets.array()).all()) least_s = std::min(least_s, cost_s);
    });
    ASSERT_TRUE(std::isfinite(least_s));
    EXPECT_TRUE(design.meets) << seed;
    EXPECT_FALSE(design.efficiency.has_value());
    EXPECT_LE(design.covariance(0, 0), 0.4 * 0.4);
    EXPECT_LE(design.covariance(2, 2), 0.3 * 0.3);
    ratios += design.cost_s / least_s;
  }
  // In 300 problems of this kind 1.01 in the mean, and 1.12 by adding and taking away alone.
  EXPECT_LE(ratios / kSeeds, 1.05);
}

TEST(ExperimentDesign, SaysThatTargetsAreNotMet) {
  const std::vector<PossibleRun> runs = {At(-1, 2, 1, 2), At(1, 2, 1, 2)};
  const ExperimentDesign design =
      BestDesign(Weak(2), runs, {.budget_s = 100, .targets = Eigen::Vector2d::Constant(1e-3)});
  EXPECT_FALSE(design.meets);
  EXPECT_EQ(design.repeats, (std::vector<int>{2, 2}));
}

// Of errors that stay there is no use in repeats: a second one of the noisy run instead.
TEST(ExperimentDesign, RepeatsWhatRepeatsImprove) {
  std::vector<PossibleRun> runs = {At(-1, 2), At(1, 2)};
  runs[0].noise[0] = 1e-6;
  runs[0].floor[0] = 1;
  const ExperimentDesign design = BestDesign(Weak(2), runs, {.budget_s = 6});
  EXPECT_EQ(design.repeats, (std::vector<int>{1, 5}));
}

}  // namespace
}  // namespace fourpost::experiment_design_test
