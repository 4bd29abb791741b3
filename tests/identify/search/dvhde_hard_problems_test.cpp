// dvHDE on problems that leave it little to work with: each ends with a clear result.
#include <cmath>

#include <gmock/gmock.h>

#include "analysis/signals/mix_bits.h"
#include "identify/refine/search_method_list.h"
#include "tests/identify/test_problems.h"

namespace fourpost::dvhde_hard_problems_test {
namespace {

using testing::HasSubstr;

SearchResult SearchBy(std::string_view method, const Problem& problem, std::int64_t evaluations,
                      std::optional<double> target = {}) {
  Archive archive(problem);
  StopRules rules{.max_evaluations = evaluations, .max_generations = 100000};
  rules.target_cost = target;
  return RunMethod(MethodPreset(method, problem), archive, 1, rules, {});
}

Problem Bowl(std::vector<LatticeAxis> axes, Eigen::Index residual_count) {
  const auto evaluate = [](const Eigen::VectorXd& x) {
    Evaluation evaluation;
    evaluation.residuals = x.array() - 0.3;
    return evaluation;
  };
  return {.lattice = Lattice(std::move(axes)), .evaluate = evaluate, .residual_count = residual_count};
}

// Accelerated by pattern search where the residuals are fewer than parameters, else by Levenberg-Marquardt.
class HardProblem : public testing::TestWithParam<Eigen::Index> {};

INSTANTIATE_TEST_SUITE_P(Dvhde, HardProblem, testing::Values(0, 200));

// A lattice of one point, or a precision coarser than the range, is no lattice: see LatticeFaults.
TEST_P(HardProblem, OfFourPointsEndsWhenAllAreKnown) {
  const Problem problem =
      Bowl({{"a", 0, 1, 1}, {.name = "b", .lower = 0, .upper = 1, .precision = 1, .discrete = true}}, GetParam());
  const SearchResult result = SearchBy("dvhde", problem, 1000);
  EXPECT_EQ(result.end, SearchEnd::kNothingNew);
  EXPECT_NEAR(result.best().cost, 2 * 0.3 * 0.3, 1e-12);
}

TEST_P(HardProblem, WithoutAFeasiblePointSaysSo) {
  Problem problem = Bowl({{"a", 0, 1, 1e-3}, {"b", 0, 1, 1e-3}}, GetParam());
  problem.evaluate = [](const Eigen::VectorXd& x) { return Infeasible(1 + x.sum(), "too heavy"); };
  Archive archive(problem);
  const SearchResult result =
      RunMethod(MethodPreset("dvhde", problem), archive, 1, {.max_evaluations = 500, .max_generations = 10000}, {});
  EXPECT_TRUE(result.candidates.empty());
  EXPECT_THAT(result.reason, HasSubstr("500 of 500 evaluations"));
  EXPECT_EQ(archive.counts().failures.at(Failure::kInfeasible).example, "too heavy");
}

// The noise is repeatable, since an archive asks for a point once, but has no slope.
TEST_P(HardProblem, OfNoiseEndsWithItsBudget) {
  Problem problem = Bowl({{"a", 0, 1, 1e-3}, {"b", 0, 1, 1e-3}}, GetParam());
  problem.evaluate = [](const Eigen::VectorXd& x) {
    const auto bits =
        MixBits(static_cast<std::uint64_t>(1e6 * x[0]) * 1000003 + static_cast<std::uint64_t>(1e6 * x[1]));
    Evaluation evaluation;
    evaluation.residuals = (x.array() - 0.3).matrix() * (0.5 + static_cast<double>(bits % 1000) / 1000);
    return evaluation;
  };
  const SearchResult result = SearchBy("dvhde", problem, 3000);
  EXPECT_EQ(result.end, SearchEnd::kEvaluations);
  // The noise scales a cost by at most nine: the best is near the bottom of the bowl.
  EXPECT_NEAR(result.best().values[0], 0.3, 0.02);
  EXPECT_NEAR(result.best().values[1], 0.3, 0.02);
}

TEST_P(HardProblem, OfTwoHundredParametersIsSolved) {
  std::vector<LatticeAxis> axes;
  for (int i = 0; i < 200; ++i) axes.push_back({"x" + std::to_string(i), 0, 1, 1e-3});
  const Problem problem = Bowl(axes, GetParam());
  const SearchResult result = SearchBy("dvhde", problem, 30000, 1e-3);
  // Each of the 200 within 0.002.
  EXPECT_EQ(result.end, SearchEnd::kTarget) << result.reason << ", " << result.best().cost;
}

TEST(SearchGains, AreCountedForAccelerationsAndMigrations) {
  const SearchResult gears = SearchBy("dvhde", GearTrain(), 4000);
  EXPECT_GT(gears.migrations.count, 0);
  EXPECT_LE(gears.migrations.successes, gears.migrations.count);
  // Two points for each of 20 and more members.
  EXPECT_GE(gears.migrations.evaluations, 30 * gears.migrations.count);
  const SearchResult spring = SearchBy("dvhde", CoilSpring(1e-6), 1000);
  EXPECT_GT(spring.accelerations.count, 10);
  EXPECT_GT(spring.accelerations.successes, 0);
  EXPECT_LT(spring.accelerations.cost_ratio, 1);
  EXPECT_GT(spring.accelerations.evaluations, spring.accelerations.count);
  const SearchResult plain = SearchBy("de", CoilSpring(1e-6), 1000);
  EXPECT_EQ(plain.accelerations, SearchGain());
  EXPECT_EQ(plain.migrations, SearchGain());
}

TEST(AlgorithmName, IsOfWhatRuns) {
  for (const std::string_view name : {"dvhde", "thesis", "de", "adaptive", "cmaes", "simplex", "multistart", "bfgs"})
    EXPECT_EQ(AlgorithmName(MethodPreset(name, MassSpringDamper())), name);
  // Fewer residuals than parameters.
  EXPECT_EQ(AlgorithmName(MethodPreset("gb", GearTrain())), "bfgs");
  EXPECT_EQ(AlgorithmName(MethodPreset("auto", GearTrain())), "cmaes");
  DvhdeOptions options = ThesisDvhde();
  options.factor = 0.8;
  EXPECT_EQ(AlgorithmName(options), "dvhde");
}

}  // namespace
}  // namespace fourpost::dvhde_hard_problems_test
