#include "identify/refine/multi_start.h"

#include <stdexcept>

#include <gmock/gmock.h>

#include "identify/problems/oscillator.h"
#include "identify/refine/quasi_newton.h"
#include "tests/identify/test_problems.h"

namespace fourpost::multi_start_test {
namespace {

constexpr StopRules kRules = {.target_cost = kOscillatorTarget, .max_evaluations = 2000, .max_generations = 100};

TEST(MultiStart, FindsTheOscillatorByEveryDescent) {
  for (const Descent descent : {Descent::kLevenbergMarquardt, Descent::kQuasiNewton})
    for (const std::int64_t explore : {0, 30}) {
      Archive archive(OscillatorProblem());
      const MultiStartOptions options = {.descent = descent, .explore_evaluations = explore};
      const SearchResult result = RunMultiStart(archive, options, 3, kRules, {});
      EXPECT_EQ(result.end, SearchEnd::kTarget) << result.reason;
      EXPECT_LE(archive.improvements().back().cost, kOscillatorTarget);
    }
}

TEST(MultiStart, RefinesAsOftenAsItIsTold) {
  Archive archive(OscillatorProblem());
  StopRules rules = kRules;
  rules.target_cost.reset();
  const SearchResult result = RunMultiStart(archive, {.starts = 3}, 3, rules, {});
  EXPECT_EQ(result.end, SearchEnd::kFinished);
  EXPECT_EQ(result.log.size(), 3u);
}

TEST(MultiStart, EndsSoonAfterItsBudget) {
  Archive archive(OscillatorProblem());
  StopRules rules = kRules;
  rules.target_cost.reset();
  rules.max_evaluations = 40;
  EXPECT_EQ(RunMultiStart(archive, {}, 3, rules, {}).end, SearchEnd::kEvaluations);
  EXPECT_GE(archive.counts().paid, 40);
  // An iteration's evaluations: a step and a Jacobian of three columns, and what the search for a step takes.
  EXPECT_LE(archive.counts().paid, 60);
}

TEST(MultiStart, LeavesAPlaceWhereNothingCanBeEvaluated) {
  const Problem oscillator = OscillatorProblem();
  Archive archive({oscillator.lattice, [&](const Eigen::VectorXd& p) {
                     return p[0] > 300 ? Failed(Failure::kNotConverged, "heavy") : oscillator.evaluate(p);
                   }});
  EXPECT_EQ(RunMultiStart(archive, {}, 1, kRules, {}).end, SearchEnd::kTarget);
  EXPECT_GT(archive.counts().failed(), 0);
}

// Rosenbrock's valley with its end beyond a bound: at a = 0.5 the best b is 0.25.
TEST(QuasiNewton, FollowsAValleyToABound) {
  const Lattice lattice({{"a", -2, 0.5, 0.01}, {"b", -2, 2, 0.01}});
  Archive archive({lattice, [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::Vector2d(1 - p[0], 10 * (p[1] - p[0] * p[0]));
                     return evaluation;
                   }});
  const RefineResult result = MinimiseQuasiNewton(archive, Eigen::Vector2d(-1.2, 1));
  EXPECT_EQ(result.end, RefineEnd::kConverged) << result.message;
  // Flat in the sine's angle near the bound.
  EXPECT_NEAR(result.values[0], 0.5, 1e-4);
  EXPECT_NEAR(result.values[1], 0.25, 1e-3);
  EXPECT_NEAR(result.cost, 0.25, 1e-4);
  EXPECT_EQ(result.evaluations, archive.counts().paid);
}

TEST(QuasiNewton, NamesAStartOutOfBounds) {
  Archive archive(Flat());
  EXPECT_THAT([&] { MinimiseQuasiNewton(archive, Eigen::Vector2d(-1, 1)); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("a = -1, must be in [0, 1000]")));
}

}  // namespace
}  // namespace fourpost::multi_start_test
