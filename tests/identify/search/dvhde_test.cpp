#include "identify/search/dvhde.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/search/draws.h"
#include "tests/identify/test_problems.h"
#include "tests/rounding.h"

namespace fourpost::dvhde_test {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

// Every generation: its log, and a sum of hashes of all points evaluated so far, which does not depend on their order.
struct History {
  std::vector<SearchGeneration> log;
  std::vector<std::uint64_t> points;

  bool operator==(const History&) const = default;
};

History HistoryOf(const Problem& problem, const DvhdeSearch& options, int threads) {
  std::mutex mutex;
  std::uint64_t sum = 0;
  const Problem observed = {problem.lattice, [&](const Eigen::VectorXd& values) {
                              std::uint64_t hash = 0;
                              for (const std::int64_t e : problem.lattice.Nearest(values)) {
                                hash = MixBits(hash ^ static_cast<std::uint64_t>(e));
                              }
                              const std::lock_guard lock(mutex);
                              sum += hash;
                              return problem.evaluate(values);
                            }};
  Archive archive(observed, threads);
  History history;
  SearchHooks hooks;
  hooks.progress = [&](const SearchGeneration&) { history.points.push_back(sum); };
  history.log = SearchDvhde(archive, options, hooks).log;
  return history;
}

// With accelerations, migrations of both kinds, and for the spring failures.
DvhdeSearch Busy() {
  DvhdeSearch options;
  options.population = 12;
  options.migrate_after = 4;
  options.migrate_below_diversity = 0.3;
  options.max_evaluations = 2000;
  options.max_generations = 60;
  return options;
}

TEST(Dvhde, GivesTheSameHistoryForAnyNumberOfThreads) {
  for (const Problem& problem : {GearTrain(), CoilSpring(1e-6)}) {
    const History alone = HistoryOf(problem, Busy(), 1);
    EXPECT_EQ(alone, HistoryOf(problem, Busy(), 1));
    EXPECT_EQ(alone, HistoryOf(problem, Busy(), 2));
    EXPECT_EQ(alone, HistoryOf(problem, Busy(), 4));
    EXPECT_TRUE(std::any_of(alone.log.begin(), alone.log.end(), [](const auto& g) { return g.accelerated; }));
    EXPECT_TRUE(std::any_of(alone.log.begin(), alone.log.end(), [](const auto& g) { return g.migrated; }));
  }
}

TEST(Dvhde, GivesAnotherHistoryForAnotherSeedOrRule) {
  std::set<std::uint64_t> last;
  std::size_t runs = 0;
  const auto add = [&](const DvhdeSearch& options) {
    ++runs;
    last.insert(HistoryOf(GearTrain(), options, 1).points.back());
  };
  DvhdeSearch options = Busy();
  for (options.seed = 0; options.seed < 10; ++options.seed) add(options);
  options = Busy();
  for (const auto base : {MutationBase::kRandom, MutationBase::kBest}) {
    for (const auto rule : {MutationFactor::kConstant, MutationFactor::kPerGeneration, MutationFactor::kPerGene}) {
      options.base = base;
      options.factor_rule = rule;
      options.seed = 99;
      add(options);
    }
  }
  EXPECT_EQ(last.size(), runs);
}

TEST(Dvhde, PaysExactlyItsBudget) {
  for (const std::int64_t budget : {1, 3, 12, 13, 30, 77, 500}) {
    std::int64_t calls = 0;
    Archive archive({GearTrain().lattice, [&](const Eigen::VectorXd& z) {
                       ++calls;
                       return GearTrain().evaluate(z);
                     }});
    DvhdeSearch options = Busy();
    options.max_generations = 1000;
    options.max_evaluations = budget;
    const SearchResult result = SearchDvhde(archive, options);
    EXPECT_EQ(result.end, SearchEnd::kEvaluations);
    EXPECT_EQ(result.log.back().paid, budget);
    EXPECT_EQ(calls, budget);
    EXPECT_EQ(result.best().cost, archive.Best(1, 0).front().cost);
  }
}

TEST(Dvhde, RepeatsASearchForNothingAndThenGoesOn) {
  Archive archive(GearTrain());
  DvhdeSearch options = Busy();
  options.max_generations = 1000;
  options.max_evaluations = 500;
  const SearchResult first = SearchDvhde(archive, options);
  // Less than a generation, had it to be paid for.
  options.max_evaluations = 5;
  const SearchResult second = SearchDvhde(archive, options);
  EXPECT_GE(second.log.size(), first.log.size());
  EXPECT_EQ(second.log[first.log.size() - 2].paid, 0);
  EXPECT_EQ(second.log.back().paid, 5);
  EXPECT_EQ(archive.counts().paid, 505);
  options.max_evaluations = 505;
  Archive fresh(GearTrain());
  EXPECT_EQ(SearchDvhde(fresh, options).log.back().best_cost, second.log.back().best_cost);
}

TEST(Dvhde, EndsAtItsLastGeneration) {
  Archive archive(GearTrain());
  DvhdeSearch options = Busy();
  options.max_evaluations = 100000;
  options.max_generations = 7;
  const SearchResult result = SearchDvhde(archive, options);
  EXPECT_EQ(result.end, SearchEnd::kGenerations);
  ASSERT_EQ(result.log.size(), 8u);
  for (int generation = 0; generation < 8; ++generation) {
    EXPECT_EQ(result.log[static_cast<std::size_t>(generation)].generation, generation);
  }
}

TEST(Dvhde, EndsAtTheFirstGenerationThatReachesTheTarget) {
  Archive archive(MassSpringDamper());
  DvhdeSearch options;
  options.target_cost = 100;
  const SearchResult result = SearchDvhde(archive, options);
  EXPECT_EQ(result.end, SearchEnd::kTarget);
  EXPECT_LE(result.best().cost, 100);
  EXPECT_EQ(result.log.back().best_cost, result.best().cost);
  EXPECT_GT(result.log[result.log.size() - 2].best_cost, 100);
}

TEST(Dvhde, StopsWithTheBestSoFar) {
  double least = kInfinity;
  Archive archive({GearTrain().lattice, [&](const Eigen::VectorXd& z) {
                     const Evaluation evaluation = GearTrain().evaluate(z);
                     least = std::min(least, evaluation.cost());
                     return evaluation;
                   }});
  int asked = 0;
  SearchHooks hooks;
  hooks.stop = [&] { return ++asked > 10; };
  const SearchResult result = SearchDvhde(archive, Busy(), hooks);
  EXPECT_EQ(result.end, SearchEnd::kStopped);
  EXPECT_EQ(asked, 11);
  EXPECT_EQ(result.best().cost, least);
  EXPECT_EQ(result.log.back().best_cost, least);
}

TEST(Dvhde, StoppedBeforeItBeganHasNoBest) {
  Archive archive(GearTrain());
  SearchHooks hooks;
  hooks.stop = [] { return true; };
  const SearchResult result = SearchDvhde(archive, Busy(), hooks);
  EXPECT_EQ(result.end, SearchEnd::kStopped);
  EXPECT_EQ(archive.counts().paid, 0);
  EXPECT_THROW(result.best(), std::logic_error);
}

TEST(Dvhde, TellsEachGenerationAsItsLogHasIt) {
  Archive archive(GearTrain());
  std::vector<SearchGeneration> told;
  SearchHooks hooks;
  hooks.progress = [&](const SearchGeneration& generation) { told.push_back(generation); };
  EXPECT_EQ(SearchDvhde(archive, Busy(), hooks).log, told);
}

TEST(Dvhde, LogsTotalsAndACostThatNeverRises) {
  Archive archive(CoilSpring(1e-6));
  const SearchResult result = SearchDvhde(archive, Busy());
  for (std::size_t i = 1; i < result.log.size(); ++i) {
    EXPECT_LE(result.log[i].best_cost, result.log[i - 1].best_cost);
    EXPECT_GE(result.log[i].paid, result.log[i - 1].paid);
  }
  EXPECT_EQ(result.log.back().paid, archive.counts().paid);
  EXPECT_EQ(result.log.back().reused, archive.counts().reused);
  EXPECT_EQ(result.log.back().failed, archive.counts().failed());
  EXPECT_GT(archive.counts().failed(), 0);
}

TEST(Dvhde, HasNothingToReportWhenEveryEvaluationFails) {
  Archive archive({Flat().lattice, [](const Eigen::VectorXd&) { return OneResidual(std::nan("")); }});
  DvhdeSearch options = Busy();
  options.max_generations = 20;
  const SearchResult result = SearchDvhde(archive, options);
  EXPECT_TRUE(result.candidates.empty());
  EXPECT_THROW(result.best(), std::logic_error);
  EXPECT_EQ(result.log.back().best_cost, kInfinity);
  EXPECT_EQ(result.log.back().failed, result.log.back().paid);
}

// A sphere about a corner of the holes, where methods that keep NaN members for good lose their way.
TEST(Dvhde, FindsTheOptimumWithHolesInAThirdOfTheSpace) {
  const Lattice lattice({{"a", -1, 1, 1e-4}, {"b", -1, 1, 1e-4}, {"c", -1, 1, 1e-4}});
  const auto sphere = [](const Eigen::VectorXd& p) {
    if (p[0] > 0.3401) return OneResidual(std::nan(""));
    Evaluation evaluation;
    evaluation.residuals = p - Eigen::Vector3d(0.34, -0.2, 0.7);
    return evaluation;
  };
  DvhdeSearch options;
  options.max_evaluations = 10000;
  // Ten steps of the lattice.
  EXPECT_EQ(Runs({lattice, sphere}, options, 20, 1e-6).solved, 20);
}

TEST(Dvhde, ReportsCandidatesApart) {
  Archive archive(MassSpringDamper());
  DvhdeSearch options;
  options.max_evaluations = 1500;
  options.candidates = 4;
  options.candidate_separation = 0.1;
  const SearchResult result = SearchDvhde(archive, options);
  ASSERT_EQ(result.candidates.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(result.candidates[i].cost, result.candidates[k].cost);
      EXPECT_GT(LatticeDistance(archive.lattice(), result.candidates[i].point, result.candidates[k].point), 0.1);
    }
  }
}

// On a flat cost every generation is without gain.
class DvhdeOnFlat : public testing::Test {
 protected:
  DvhdeOnFlat() {
    options_.population = 10;
    options_.migrate_after = 0;
    options_.simplex_iterations = 0;
    options_.max_generations = 12;
  }

  std::vector<int> Generations(bool SearchGeneration::*flag) const {
    Archive archive(Flat());
    std::vector<int> flagged;
    for (const SearchGeneration& generation : SearchDvhde(archive, options_).log) {
      if (generation.*flag) flagged.push_back(generation.generation);
    }
    return flagged;
  }

  DvhdeSearch options_;
};

TEST_F(DvhdeOnFlat, NeitherMigratesNorAcceleratesWhenTurnedOff) {
  EXPECT_THAT(Generations(&SearchGeneration::migrated), ElementsAre());
  EXPECT_THAT(Generations(&SearchGeneration::accelerated), ElementsAre());
}

TEST_F(DvhdeOnFlat, MigratesAfterTheGenerationsWithoutGain) {
  options_.migrate_after = 5;
  EXPECT_THAT(Generations(&SearchGeneration::migrated), ElementsAre(5, 10));
}

TEST_F(DvhdeOnFlat, MigratesBelowTheDiversity) {
  options_.max_generations = 3;
  options_.gene_difference = 0.5;
  // No gene can be further than half the range from all others in both directions, so some always count as alike.
  options_.migrate_below_diversity = 1;
  EXPECT_THAT(Generations(&SearchGeneration::migrated), ElementsAre(1, 2, 3));
}

TEST_F(DvhdeOnFlat, AcceleratesWhileTheCostDoesNotFall) {
  options_.simplex_iterations = 5;
  options_.max_generations = 3;
  EXPECT_THAT(Generations(&SearchGeneration::accelerated), ElementsAre(1, 2, 3));
}

TEST_F(DvhdeOnFlat, DoesNotAccelerateWhenTheCostNeedNotFall) {
  options_.simplex_iterations = 5;
  options_.accelerate_below = 0;
  EXPECT_THAT(Generations(&SearchGeneration::accelerated), ElementsAre());
}

TEST(Dvhde, AcceleratesOnlyWhenTheCostFellTooLittle) {
  Archive archive(MassSpringDamper());
  DvhdeSearch options;
  options.migrate_after = 0;
  const std::vector<SearchGeneration> log = SearchDvhde(archive, options).log;
  int slow = 0;
  for (std::size_t i = 1; i < log.size(); ++i) {
    slow += log[i].accelerated;
    // An acceleration may itself bring the cost down, so that only its absence says something.
    const bool fell = log[i].best_cost <= 0.9 * log[i - 1].best_cost;
    EXPECT_TRUE(fell || log[i].accelerated || log[i - 1].best_cost == 0) << log[i].generation;
  }
  EXPECT_GT(slow, 0);
  EXPECT_LT(slow, static_cast<int>(log.size()) - 1);
}

// What it asks to have refined until it migrates, if no refinement gains.
std::vector<LatticePoint> RefinedBeforeMigration(int random_starts) {
  const Lattice lattice({{"a", 0, 1, 1e-6}, {"b", 0, 1, 1e-6}});
  Dvhde dvhde(lattice, {.acceleration = Acceleration::kLeastSquares, .random_starts = random_starts}, 1);
  std::vector<Score> scores;
  for (std::size_t i = 0; i < dvhde.Ask().size(); ++i) scores.push_back({.cost = 1 + static_cast<double>(i)});
  const LatticePoint best = dvhde.Ask().front();
  dvhde.Tell(scores);
  std::vector<LatticePoint> refined;
  while (!dvhde.AskRefined().empty()) {
    Population found;
    for (const LatticePoint& point : dvhde.AskRefined()) {
      refined.push_back(point);
      found.push_back({point, {.cost = point == best ? 1.0 : 100.0}});
    }
    dvhde.TellRefined(found, 30);
  }
  EXPECT_EQ(dvhde.state().step, SearchStep::kMigrate);
  EXPECT_EQ(refined.front(), best);
  return refined;
}

TEST(Dvhde, RefinesRandomPointsAfterTheBestMember) {
  EXPECT_EQ(RefinedBeforeMigration(0).size(), 1u);
  const std::vector<LatticePoint> refined = RefinedBeforeMigration(2);
  ASSERT_EQ(refined.size(), 3u);
  EXPECT_EQ(std::set<LatticePoint>(refined.begin(), refined.end()).size(), 3u);
}

struct BadOption {
  const char* message;
  void (*spoil)(DvhdeSearch& options);
};

std::ostream& operator<<(std::ostream& out, const BadOption& fault) { return out << fault.message; }

class DvhdeBadOption : public testing::TestWithParam<BadOption> {};

TEST_P(DvhdeBadOption, IsNamedBeforeAnythingIsEvaluated) {
  DvhdeSearch options;
  GetParam().spoil(options);
  Archive archive(Flat());
  EXPECT_THAT([&] { SearchDvhde(archive, options); }, ThrowsMessage<std::invalid_argument>(StrEq(GetParam().message)));
  EXPECT_EQ(archive.counts().paid, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Dvhde, DvhdeBadOption,
    testing::Values(
        BadOption{"population = 3, must be 4 or more", [](DvhdeSearch& o) { o.population = 3; }},
        BadOption{"factor = 0, must be in (0, 2]", [](DvhdeSearch& o) { o.factor = 0; }},
        BadOption{"factor = 2.1, must be in (0, 2]", [](DvhdeSearch& o) { o.factor = 2.1; }},
        BadOption{"factor = nan, must be in (0, 2]", [](DvhdeSearch& o) { o.factor = std::nan(""); }},
        BadOption{"crossover = 1.1, must be in [0, 1]", [](DvhdeSearch& o) { o.crossover = 1.1; }},
        BadOption{"simplex_iterations = -1, must be 0 or more", [](DvhdeSearch& o) { o.simplex_iterations = -1; }},
        BadOption{"accelerate_below = -0.1, must be in [0, 1]", [](DvhdeSearch& o) { o.accelerate_below = -0.1; }},
        BadOption{"random_starts = -1, must be 0 or more", [](DvhdeSearch& o) { o.random_starts = -1; }},
        BadOption{"migrate_after = -1, must be 0 or more", [](DvhdeSearch& o) { o.migrate_after = -1; }},
        BadOption{"migrate_below_diversity = 1.5, must be in [0, 1]",
                  [](DvhdeSearch& o) { o.migrate_below_diversity = 1.5; }},
        BadOption{"gene_difference = 1, must be in (0, 1)", [](DvhdeSearch& o) { o.gene_difference = 1; }},
        BadOption{"max_evaluations = 0, must be 1 or more", [](DvhdeSearch& o) { o.max_evaluations = 0; }},
        BadOption{"max_generations = -1, must be 0 or more", [](DvhdeSearch& o) { o.max_generations = -1; }},
        BadOption{"target_cost = -1, must be 0 or more", [](DvhdeSearch& o) { o.target_cost = -1; }},
        BadOption{"candidates = 0, must be 1 or more", [](DvhdeSearch& o) { o.candidates = 0; }},
        BadOption{"candidate_separation = 1, must be in [0, 1)", [](DvhdeSearch& o) { o.candidate_separation = 1; }}));

}  // namespace
}  // namespace fourpost::dvhde_test
