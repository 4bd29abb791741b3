#include "identify/comparison/comparison.h"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/process/thread_time.h"
#include "identify/comparison/comparison_json.h"
#include "identify/problems/test_problem.h"
#include "tests/identify/test_problems.h"

namespace fourpost::comparison_test {
namespace {

using testing::ElementsAre;

std::vector<ComparedMethod> Methods(const Problem& problem, const std::vector<std::string>& names) {
  std::vector<ComparedMethod> methods;
  for (const std::string& name : names) methods.push_back({name, MethodPreset(name, problem)});
  return methods;
}

ComparisonOptions GearOptions(int runs, int threads) {
  return {.runs = runs,
          .seed = 7,
          .threads = threads,
          .rules = {.target_cost = kGearTarget, .max_evaluations = 3000, .max_generations = 1000}};
}

TEST(Comparison, IsTheSameForAnyNumberOfThreads) {
  const Problem problem = GearTrain();
  const auto json = [&](int threads) {
    const auto methods = Methods(problem, {"dvhde", "thesis", "de", "simplex", "gb", "multistart", "adaptive"});
    return ComparisonJson(Compare(problem, methods, GearOptions(6, threads)), "gears", 7);
  };
  EXPECT_EQ(json(1), json(2));
  EXPECT_EQ(json(1), json(4));
}

TEST(Comparison, CountsEvaluationsUpToTheTarget) {
  std::int64_t calls = 0;
  // Solved by the third evaluation, whatever the point.
  const Problem third = {Flat().lattice,
                         [&](const Eigen::VectorXd&) { return OneResidual(++calls % 20 == 3 ? 0 : 1); }};
  const ComparisonOptions options = {.runs = 1, .rules = {.target_cost = 0.5}};
  const Comparison comparison = Compare(third, Methods(third, {"thesis"}), options);
  EXPECT_EQ(calls, 20);  // the initial population
  EXPECT_EQ(comparison.methods[0].outcomes[0].evaluations, 3);
  EXPECT_EQ(comparison.methods[0].expected_evaluations, 3);
}

TEST(Comparison, AddsUpEveryRun) {
  const Problem problem = GearTrain();
  const MethodSummary method = Compare(problem, Methods(problem, {"dvhde"}), GearOptions(30, 2)).methods[0];
  double evaluations = 0;
  std::int64_t solved = 0;
  for (const RunOutcome& outcome : method.outcomes) {
    evaluations += static_cast<double>(outcome.evaluations);
    solved += outcome.solved;
    EXPECT_EQ(outcome.solved, outcome.cost <= kGearTarget);
    EXPECT_TRUE(outcome.solved || outcome.evaluations == 3000);
  }
  ASSERT_EQ(method.outcomes.size(), 30u);
  // Some, but not all.
  ASSERT_GT(solved, 5);
  ASSERT_LT(solved, 30);
  EXPECT_EQ(method.successes, solved);
  EXPECT_DOUBLE_EQ(method.evaluations_mean, evaluations / 30);
  EXPECT_DOUBLE_EQ(method.expected_evaluations, evaluations / static_cast<double>(solved));
  EXPECT_LT(method.expected_interval.lower, method.expected_evaluations);
  EXPECT_GT(method.expected_interval.upper, method.expected_evaluations);
  EXPECT_EQ(method.ends.at(SearchEnd::kTarget), solved);
  EXPECT_EQ(method.ends.at(SearchEnd::kEvaluations), 30 - solved);
}

// R: binom.confint(8, 10, methods = "wilson"), (0, 20), (1000, 1000).
TEST(Comparison, HasWilsonsInterval) {
  EXPECT_NEAR(WilsonInterval(8, 10).lower, 0.4901625, 1e-6);
  EXPECT_NEAR(WilsonInterval(8, 10).upper, 0.9433178, 1e-6);
  EXPECT_EQ(WilsonInterval(0, 20).lower, 0);
  EXPECT_NEAR(WilsonInterval(0, 20).upper, 0.1611252, 1e-6);
  EXPECT_NEAR(WilsonInterval(1000, 1000).lower, 0.9961733, 1e-6);
}

TEST(Comparison, TakesTheBestOfAllRunsForTheTargetWhereNoneIsGiven) {
  Problem problem = MassSpringDamper();
  problem.residual_count = 80;
  const ComparisonOptions options = {.runs = 3, .rules = {.max_evaluations = 300}};
  const Comparison comparison = Compare(problem, Methods(problem, {"gb", "simplex"}), options);
  double best = 1e300;
  for (const MethodSummary& method : comparison.methods)
    for (const RunOutcome& outcome : method.outcomes) best = std::min(best, outcome.cost);
  EXPECT_DOUBLE_EQ(comparison.target_cost, 1.01 * best);
  EXPECT_EQ(comparison.parameters, 3u);
  EXPECT_EQ(comparison.residuals, 80u);
  EXPECT_GT(comparison.methods[0].successes + comparison.methods[1].successes, 0);
}

TEST(Comparison, LeavesOutRunsThatWereStopped) {
  const Problem problem = GearTrain();
  int asked = 0;
  const Comparison comparison =
      Compare(problem, Methods(problem, {"de"}), GearOptions(50, 1), {.stop = [&] { return ++asked > 300; }});
  EXPECT_TRUE(comparison.interrupted);
  EXPECT_GT(comparison.methods[0].outcomes.size(), 0u);
  EXPECT_LT(comparison.methods[0].outcomes.size(), 50u);
}

TEST(Comparison, RunsMethodsOfOtherPeople) {
  ForeignMethod first;
  first.settings = {{"points", "1"}};
  first.run = [](Archive& archive, std::uint64_t seed, const StopRules& rules, const std::function<bool()>&) {
    archive.Evaluate({LatticePoint(archive.lattice().size(), static_cast<std::int64_t>(seed))});
    return archive.improvements().back().cost <= rules.target_cost ? SearchEnd::kTarget : SearchEnd::kFinished;
  };
  const Problem problem = {Flat().lattice, [](const Eigen::VectorXd& values) { return OneResidual(values[0]); }};
  const ComparisonOptions options = {.runs = 3, .seed = 2, .rules = {.target_cost = 4.0}};
  const Comparison comparison = Compare(problem, {{.name = "first", .foreign = first}}, options);
  const MethodSummary& method = comparison.methods[0];
  // Seeds 2, 3, 4 cost 1, 4, 9.
  EXPECT_EQ(method.successes, 2);
  EXPECT_EQ(method.cost_worst, 9);
  EXPECT_EQ(method.ends.at(SearchEnd::kFinished), 1);
  EXPECT_EQ(method.expected_evaluations, 1.5);
  EXPECT_THAT(method.settings, ElementsAre(testing::Pair("points", "1")));
}

TEST(Comparison, HasTheKeysOfItsJson) {
  const Problem problem = GearTrain();
  ComparisonOptions options = GearOptions(4, 1);
  options.rules.target_cost = 0;  // out of reach
  options.rules.max_evaluations = 100;
  const auto json = nlohmann::json::parse(ComparisonJson(Compare(problem, Methods(problem, {"de"}), options), "s", 7));
  const auto& method = json.at("methods").at(0);
  EXPECT_EQ(method.at("name"), "de");
  EXPECT_EQ(method.at("runs"), 4);
  EXPECT_EQ(method.at("successes"), 0);
  EXPECT_EQ(method.at("evaluations_mean"), 100);
  EXPECT_TRUE(method.at("expected_evaluations").is_null());
  EXPECT_LE(method.at("cost_median"), method.at("cost_worst"));
  EXPECT_EQ(method.at("settings").at("population"), "20");
  EXPECT_EQ(method.at("ends").at("evaluations used up"), 4);
  ASSERT_EQ(method.at("outcomes").size(), 4u);
  EXPECT_EQ(method.at("outcomes").at(3).at(0), 100);
  EXPECT_LE(method.at("outcomes").at(3).at(1), method.at("cost_worst"));
  EXPECT_FALSE(method.contains("seconds"));
}

// Of a run that reached its target half way, half of the time counts.
TEST(Comparison, TellsTheTimeUpToTheTarget) {
  const auto spend = [](const Eigen::VectorXd&) {
    const double until = ThreadTime_s() + 0.001;
    while (ThreadTime_s() < until) continue;
    return OneResidual(1);
  };
  const Problem problem = {Flat().lattice, spend};
  ForeignMethod ten;
  ten.run = [](Archive& archive, std::uint64_t, const StopRules&, const std::function<bool()>&) {
    for (std::int64_t index = 1; index <= 10; ++index)
      archive.Evaluate({LatticePoint(archive.lattice().size(), index)});
    return SearchEnd::kFinished;
  };
  const Comparison comparison = Compare(problem, {{.name = "ten", .foreign = ten}}, {.runs = 2});
  for (const RunOutcome& outcome : comparison.methods[0].outcomes) {
    EXPECT_EQ(outcome.evaluations, 1);
    EXPECT_GE(outcome.seconds, 0.001);
    // Ten in all; what the method itself takes is little.
    EXPECT_LT(outcome.seconds, 0.005);
  }
  const auto json = nlohmann::json::parse(ComparisonJson(comparison, "s", 7, true));
  EXPECT_GE(json.at("methods").at(0).at("seconds").at("mean"), 0.001);
}

TEST(Comparison, HasNoCostsWhereEveryEvaluationFails) {
  const Problem failing = {Flat().lattice, [](const Eigen::VectorXd&) { return OneResidual(std::nan("")); }};
  const ComparisonOptions options = {.runs = 2, .rules = {.max_evaluations = 50}};
  for (const std::string name : {"de", "gb", "bfgs", "simplex", "dvhde"}) {
    const Comparison comparison = Compare(failing, Methods(failing, {name}), options);
    EXPECT_TRUE(std::isinf(comparison.methods[0].cost_median)) << name;
    EXPECT_EQ(comparison.methods[0].successes, 0) << name;
  }
}

TEST(MethodPreset, FitsTheKindOfProblem) {
  const auto is = [](const MethodOptions& options, std::string_view key, std::string_view value) {
    for (const auto& [k, v] : Settings(options))
      if (k == key) return v == value;
    return false;
  };
  EXPECT_TRUE(std::holds_alternative<CmaesOptions>(MethodPreset("auto", GearTrain())));
  EXPECT_TRUE(std::holds_alternative<AdaptiveOptions>(MethodPreset("auto", CoilSpring(1e-6))));
  // dvHDE is dvHDE everywhere.
  EXPECT_TRUE(is(MethodPreset("dvhde", GearTrain()), "acceleration", "pattern"));
  Problem smooth = MassSpringDamper();
  smooth.residual_count = 80;
  EXPECT_TRUE(is(MethodPreset("auto", smooth), "descent", "levenberg_marquardt"));
  EXPECT_TRUE(is(MethodPreset("dvhde", smooth), "acceleration", "least_squares"));
  EXPECT_TRUE(std::holds_alternative<SimplexOptions>(MethodPreset("direct", smooth)));
  EXPECT_TRUE(is(MethodPreset("gb", GearTrain()), "descent", "quasi_newton"));
  EXPECT_TRUE(is(MethodPreset("thesis", smooth), "base", "best"));
  for (const std::string_view name : kMethodNames) EXPECT_NO_THROW(Validate(MethodPreset(name, smooth))) << name;
  EXPECT_THROW(MethodPreset("nelder", smooth), std::invalid_argument);
}

// What dvHDE needs: all runs solved, and the mean over 100 seeds that nothing was tuned on below that of
// 1000 others and four of its standard deviations. 3850 (gear train) and 1413 (coil spring) are the best that an
// independent program reached, 173 (half car) dvHDE's 100 evaluations followed by Levenberg-Marquardt there. The half
// car with wrong bounds: of 100 others, with both means' deviations.
struct Needed {
  const char* problem;
  double most = 0;
};

std::ostream& operator<<(std::ostream& out, const Needed& needed) { return out << needed.problem; }

class DefaultPreset : public testing::TestWithParam<Needed> {};

TEST_P(DefaultPreset, SolvesItsProblemEveryTimeAtItsPrice) {
  const TestProblem test = MakeTestProblem(GetParam().problem);
  const ComparisonOptions options = {
      .runs = 100,
      .seed = 200001,
      .threads = 0,
      .rules = {.target_cost = test.target_cost, .max_evaluations = 80000, .max_generations = 100000}};
  const MethodSummary method = Compare(test.problem, Methods(test.problem, {"dvhde"}), options).methods[0];
  EXPECT_EQ(method.successes, 100);
  EXPECT_LT(method.expected_evaluations, GetParam().most);
}

INSTANTIATE_TEST_SUITE_P(Comparison, DefaultPreset,
                         testing::Values(Needed{"oscillator", 36}, Needed{"gear_train", 2600},
                                         Needed{"coil_spring", 1560}, Needed{"pressure_vessel", 15000},
                                         Needed{"half_car", 140}, Needed{"half_car_out_of_bounds", 1030}));

}  // namespace
}  // namespace fourpost::comparison_test
