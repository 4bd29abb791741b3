#include "identify/search/run_search.h"

#include <limits>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/search/adaptive_evolution.h"
#include "identify/search/cmaes.h"
#include "identify/search/downhill_simplex.h"
#include "identify/search/dvhde.h"
#include "tests/identify/test_problems.h"

namespace fourpost::run_search_test {
namespace {

using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

constexpr int kMany = std::numeric_limits<int>::max();

SearchResult SearchGears(const StopRules& rules, const DvhdeOptions& options = PlainEvolution()) {
  Archive archive(GearTrain());
  Dvhde method(archive.lattice(), options, 1);
  return RunSearch(archive, method, rules, {});
}

TEST(RunSearch, TellsTheTargetReached) {
  const SearchResult result = SearchGears({.target_cost = 1e-6});
  EXPECT_EQ(result.end, SearchEnd::kTarget);
  EXPECT_LE(result.best().cost, 1e-6);
  EXPECT_THAT(result.reason, HasSubstr("for 1e-06"));
}

TEST(RunSearch, TellsEvaluationsUsedUp) {
  const SearchResult result = SearchGears({.max_evaluations = 77});
  EXPECT_EQ(result.reason, "evaluations used up: 77 of 77 evaluations");
}

TEST(RunSearch, TellsTheLastGeneration) {
  const SearchResult result = SearchGears({.max_generations = 3});
  EXPECT_EQ(result.end, SearchEnd::kGenerations);
  EXPECT_THAT(result.reason, HasSubstr("3 generations"));
}

TEST(RunSearch, TellsTimeUsedUp) {
  const SearchResult result = SearchGears({.max_seconds = 1e-9});
  EXPECT_EQ(result.end, SearchEnd::kOutOfTime);
  EXPECT_THAT(result.reason, HasSubstr("s of 1e-09 s"));
}

TEST(RunSearch, TellsTheGenerationsWithoutGain) {
  Archive archive(Flat());
  Dvhde method(archive.lattice(), PlainEvolution(), 1);
  const SearchResult result = RunSearch(archive, method, {.max_stagnant_generations = 7}, {});
  EXPECT_EQ(result.end, SearchEnd::kStagnation);
  EXPECT_EQ(result.log.size(), 8u);
  EXPECT_THAT(result.reason, HasSubstr("7 generations"));
}

TEST(RunSearch, TellsACollapsedPopulation) {
  const SearchResult result = SearchGears({.max_generations = kMany});
  EXPECT_EQ(result.end, SearchEnd::kCollapse);
  EXPECT_EQ(result.log.back().diversity, 0);
  EXPECT_EQ(SearchGears({.max_generations = 2000, .on_collapse = false}).end, SearchEnd::kNothingNew);
}

TEST(RunSearch, TellsWhenNothingNewIsAskedFor) {
  const Lattice lattice({{"a", 0, 2, 1}, {"b", 0, 2, 1}});
  Archive archive({lattice, [](const Eigen::VectorXd& p) { return OneResidual(p.sum() + 1); }});
  Dvhde method(lattice, DvhdeOptions{.migrate_after = 5}, 1);
  const SearchResult result = RunSearch(archive, method, {.max_generations = kMany, .max_free_generations = 50}, {});
  EXPECT_EQ(result.end, SearchEnd::kNothingNew);
  EXPECT_EQ(archive.counts().paid, 9);
  EXPECT_THAT(result.reason, HasSubstr("50 generations without a new point"));
}

struct BadRule {
  const char* message;
  void (*spoil)(StopRules& rules);
};

std::ostream& operator<<(std::ostream& out, const BadRule& fault) { return out << fault.message; }

class RunSearchBadRule : public testing::TestWithParam<BadRule> {};

TEST_P(RunSearchBadRule, IsNamed) {
  StopRules rules;
  GetParam().spoil(rules);
  EXPECT_THAT([&] { SearchGears(rules); }, ThrowsMessage<std::invalid_argument>(StrEq(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(RunSearch, RunSearchBadRule,
                         testing::Values(BadRule{"max_seconds = nan, must be above 0",
                                                 [](StopRules& r) { r.max_seconds = std::nan(""); }},
                                         BadRule{"max_stagnant_generations = -1, must be 0 or more",
                                                 [](StopRules& r) { r.max_stagnant_generations = -1; }},
                                         BadRule{"max_free_generations = 0, must be 1 or more",
                                                 [](StopRules& r) { r.max_free_generations = 0; }}));

TEST(RunSearch, EndsHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int end = 0; end <= static_cast<int>(SearchEnd::kStopped); ++end)
    names.insert(SearchEndName(static_cast<SearchEnd>(end)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(SearchEnd::kStopped) + 1);
  EXPECT_FALSE(names.contains("unknown"));
}

// Every method asks on the lattice only, asks again for the same until it is told, and goes on as before after a pause.
template <typename Method>
class AskAndTell : public testing::Test {
 public:
  static Method Make(const Lattice& lattice, std::uint64_t seed);
};

template <>
Dvhde AskAndTell<Dvhde>::Make(const Lattice& lattice, std::uint64_t seed) {
  return {lattice, {}, seed};
}
template <>
AdaptiveEvolution AskAndTell<AdaptiveEvolution>::Make(const Lattice& lattice, std::uint64_t seed) {
  return {lattice, {}, seed};
}
template <>
Cmaes AskAndTell<Cmaes>::Make(const Lattice& lattice, std::uint64_t seed) {
  return {lattice, {}, seed};
}
template <>
DownhillSimplex AskAndTell<DownhillSimplex>::Make(const Lattice& lattice, std::uint64_t seed) {
  return {lattice, {.scouts = 5, .restarts = true}, seed};
}

using Methods = testing::Types<Dvhde, AdaptiveEvolution, Cmaes, DownhillSimplex>;
TYPED_TEST_SUITE(AskAndTell, Methods);

// Points in the order asked for, over some batches.
template <typename Method>
std::vector<LatticePoint> Drive(Method& method, Archive& archive, int batches) {
  std::vector<LatticePoint> asked;
  for (int i = 0; i < batches; ++i) {
    const std::vector<LatticePoint> batch = method.Ask();
    EXPECT_EQ(method.Ask(), batch);
    for (const LatticePoint& point : batch) EXPECT_TRUE(archive.lattice().Contains(point));
    asked.insert(asked.end(), batch.begin(), batch.end());
    method.Tell(archive.Evaluate(batch));
  }
  return asked;
}

TYPED_TEST(AskAndTell, GivesTheSamePointsForTheSameSeedAndScores) {
  for (const Problem& problem : {GearTrain(), CoilSpring(1e-6), MassSpringDamper()}) {
    const auto run = [&](std::uint64_t seed) {
      Archive archive(problem);
      TypeParam method = TestFixture::Make(problem.lattice, seed);
      return Drive(method, archive, 200);
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1), run(2));
  }
}

TYPED_TEST(AskAndTell, GoesOnFromACopyAsFromItself) {
  Archive archive(CoilSpring(1e-6));
  TypeParam method = TestFixture::Make(archive.lattice(), 3);
  Drive(method, archive, 57);
  TypeParam copy = method;
  EXPECT_EQ(Drive(copy, archive, 100), Drive(method, archive, 100));
}

TYPED_TEST(AskAndTell, SolvesASmoothProblem) {
  Archive archive(MassSpringDamper());
  TypeParam method = TestFixture::Make(archive.lattice(), 5);
  const SearchResult result =
      RunSearch(archive, method, {.target_cost = 1e-3, .max_evaluations = 20000, .max_generations = kMany}, {});
  EXPECT_EQ(result.end, SearchEnd::kTarget);
}

TYPED_TEST(AskAndTell, SurvivesAProblemThatAlwaysFails) {
  Archive archive({Flat().lattice, [](const Eigen::VectorXd&) { return OneResidual(std::nan("")); }});
  TypeParam method = TestFixture::Make(archive.lattice(), 1);
  const SearchResult result = RunSearch(archive, method, {.max_evaluations = 2000, .max_generations = 500}, {});
  EXPECT_TRUE(result.candidates.empty());
}

}  // namespace
}  // namespace fourpost::run_search_test
