#include "identify/compromise.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "identify/difference_jacobian.h"
#include "identify/fit_variables.h"
#include "identify/problems/oscillator.h"
#include "identify/refine.h"
#include "identify/search/downhill_simplex.h"
#include "identify/search/draws.h"
#include "identify/search/run_search.h"

namespace fourpost {
namespace {

/// The oscillator's motion and force with errors that no parameters explain, of the force four times those of the
/// motion.
Problem NoisyOscillator() {
  Problem problem = OscillatorProblem();
  Eigen::VectorXd noise(problem.residual_count);
  Draws draws(3, DrawPurpose::kNoise, 0, 0);
  for (Eigen::Index i = 0; i < noise.size(); ++i)
    noise[i] = (i < noise.size() / 2 ? 0.05 : 0.2) * (draws.Normal() + 0.5);
  problem.evaluate = [evaluate = problem.evaluate, noise](const Eigen::VectorXd& values) {
    Evaluation evaluation = evaluate(values);
    evaluation.residuals += noise;
    return evaluation;
  };
  return problem;
}

std::vector<OutputResiduals> MotionAndForce(const Problem& problem) {
  const Eigen::Index half = problem.residual_count / 2;
  return {{0, half, 3}, {half, half, 1}};
}

TEST(Compromise, IsTheRootOfTheWeighedMisfitsSquares) {
  const Problem problem = NoisyOscillator();
  const Problem compromise = CompromiseOf(problem, MotionAndForce(problem));
  const Eigen::Vector3d values(220, 14000, 1600);
  const Eigen::VectorXd residuals = problem.evaluate(values).residuals;
  const Eigen::Index half = residuals.size() / 2;
  const double expected =
      std::pow(3 * residuals.head(half).squaredNorm(), 2) + std::pow(residuals.tail(half).squaredNorm(), 2);
  EXPECT_NEAR(compromise.evaluate(values).cost() / expected, 1, 1e-12);  // rounding
  EXPECT_EQ(compromise.residual_count, problem.residual_count);
}

// A direct search knows of no residuals: the least cost it finds is the refinement's.
TEST(Compromise, IsRefinedToWhereADirectSearchEnds) {
  const Problem problem = NoisyOscillator();
  const Problem compromise = CompromiseOf(problem, MotionAndForce(problem));
  const Eigen::Vector3d start(300, 10000, 1000);
  Archive refined_archive(compromise);
  const RefineResult refined = Refine(refined_archive, start);
  EXPECT_EQ(refined.end, RefineEnd::kConverged);
  Archive archive(compromise);
  DownhillSimplex simplex(archive.lattice(), {.restarts = true}, 1);
  const SearchResult found = RunSearch(archive, simplex, {.max_evaluations = 3000}, {});
  ASSERT_FALSE(found.candidates.empty());
  // Steps of the lattice are a part in 1e4 of each parameter, which changes the cost by their square.
  EXPECT_NEAR(found.candidates[0].cost / refined.cost, 1, 1e-6);
  EXPECT_LT((found.candidates[0].values - refined.values).cwiseQuotient(refined.values).cwiseAbs().maxCoeff(), 2e-3);
  // Elsewhere than all residuals alike.
  Archive plain_archive(problem);
  const RefineResult plain = Refine(plain_archive, start);
  EXPECT_GT(compromise.evaluate(plain.values).cost(), 1.0001 * refined.cost);
}

TEST(Compromise, HasTheDerivativesThatDifferencesShow) {
  // The force alone, so that outputs leave residuals out.
  const Problem problem = OscillatorProblem();
  const Eigen::Index half = problem.residual_count / 2;
  Archive archive(CompromiseOf(problem, {{half, half, 2}}));
  const FitVariables variables(archive.lattice());
  const Eigen::VectorXd x = variables.FromValues(Eigen::Vector3d(220, 14000, 1600));
  const Eigen::VectorXd residuals = archive.EvaluateValues({variables.ToValues(x)}).front().residuals;
  const auto by = [&](Differences differences) {
    return DifferenceJacobian(archive, variables, x, residuals, 1e-5, differences).value();
  };
  const Eigen::MatrixXd automatic = by(Differences::kAutomatic);
  // Rounding over the step.
  EXPECT_LT((automatic - by(Differences::kCentral)).norm(), 1e-8 * automatic.norm());
}

TEST(Compromise, PassesFailuresOnAndRefusesOutputsThatAreNotThere) {
  Problem problem = OscillatorProblem();
  problem.evaluate = [](const Eigen::VectorXd&) { return Failed(Failure::kNotConverged, "no"); };
  const Evaluation failed = CompromiseOf(problem, MotionAndForce(problem)).evaluate(Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(failed.failure, Failure::kNotConverged);
  EXPECT_EQ(failed.detail, "no");
  EXPECT_THROW(CompromiseOf(problem, {{problem.residual_count, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(CompromiseOf(problem, {{0, 0, 1}}), std::invalid_argument);
  EXPECT_THROW(CompromiseOf(problem, {{0, 1, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost
