#include "identify/dvhde.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/draws.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

Evaluation OneResidual(double residual) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::Constant(1, residual);
  return evaluation;
}

// Four gears of 12 to 60 teeth for a ratio of 1 / 6.931 (Sandgren, J. Mechanical Design 112, 1990). All 49^4
// enumerated: 2.7008571e-12 for 16, 19, 43, 49 teeth, the next is 2.3e-11.
Problem GearTrain() {
  const Lattice lattice({{"A", 12, 60, 1}, {"B", 12, 60, 1}, {"C", 12, 60, 1}, {"D", 12, 60, 1}});
  return {lattice, [](const Eigen::VectorXd& z) { return OneResidual(1 / 6.931 - z[0] * z[1] / (z[2] * z[3])); }};
}
constexpr double kGearTarget = 2.70086e-12;

constexpr std::array<double, 42> kWires_in = {
    0.009, 0.0095, 0.0104, 0.0118, 0.0128, 0.0132, 0.014, 0.015, 0.0162, 0.0173, 0.018, 0.020, 0.023,  0.025,
    0.028, 0.032,  0.035,  0.041,  0.047,  0.054,  0.063, 0.072, 0.080,  0.092,  0.105, 0.120, 0.135,  0.148,
    0.162, 0.177,  0.192,  0.207,  0.225,  0.244,  0.263, 0.283, 0.307,  0.331,  0.362, 0.394, 0.4375, 0.500};

// Volume of wire of a compression spring (Sandgren, as above): number of coils, wire by its place in the catalogue,
// coil diameter; inches and pounds. The cost is the volume, so the residual its root.
Evaluation CoilSpring(const Eigen::VectorXd& p) {
  const double coils = p[0];
  const double wire = kWires_in.at(static_cast<std::size_t>(p[1]) - 1);
  const double diameter = p[2];
  const double max_load = 1000;
  const double preload = 300;
  const double index = diameter / wire;
  const double stress_factor = (4 * index - 1) / (4 * index - 4) + 0.615 / index;
  const double rate = 11.5e6 * std::pow(wire, 4) / (8 * coils * std::pow(diameter, 3));
  const double solid = 1.05 * (coils + 2) * wire;
  const double free_length = max_load / rate + solid;
  const std::array<double, 8> constraints = {
      8 * stress_factor * max_load * diameter / (std::numbers::pi * std::pow(wire, 3)) - 189000, free_length - 14,
      0.2 - wire, diameter - 3, 3 - index, preload / rate - 6,
      // Zero by definition, but for rounding.
      preload / rate + (max_load - preload) / rate + solid - free_length - 1e-9, 1.25 - (max_load - preload) / rate};
  for (const double constraint : constraints) {
    if (!(constraint <= 0)) return Failed(Failure::kInfeasible, "a constraint is violated");
  }
  return OneResidual(std::sqrt(std::pow(std::numbers::pi, 2) * diameter * wire * wire * (coils + 2) / 4));
}

Problem Spring(double diameter_step) {
  return {Lattice({{"coils", 1, 70, 1}, {"wire", 1, 42, 1}, {"diameter", 0.6, 3, diameter_step}}), CoilSpring};
}

// Transmitted motion and force of m z'' + d (z - u)' + k (z - u) = 0 at 20 frequencies, against those of 200 kg,
// 15000 N/m, 1500 Ns/m, with a noise of 0.01 of the motion and 1 % of the force.
Evaluation OneMass(const Eigen::VectorXd& p) {
  using Complex = std::complex<double>;
  Evaluation evaluation;
  evaluation.residuals.resize(80);
  const auto motion = [](double m, double k, double d, double w) {
    return Complex(k, w * d) / Complex(k - m * w * w, w * d);
  };
  for (int i = 0; i < 20; ++i) {
    const double w = 2 * std::numbers::pi * 0.5 * std::pow(10, i / 19.0);
    const Complex z = motion(p[0], p[1], p[2], w);
    const Complex z0 = motion(200, 15000, 1500, w);
    const Complex dz = (z - z0) / 0.01;
    const Complex df = (p[0] * z - 200.0 * z0) / (0.01 * std::abs(200.0 * z0));
    evaluation.residuals.segment(4 * i, 4) << dz.real(), dz.imag(), df.real(), df.imag();
  }
  return evaluation;
}

Problem MassSpringDamper() {
  return {Lattice({{"m", 100, 600, 0.01}, {"k", 5000, 25000, 0.2}, {"d", 500, 3000, 0.05}}), OneMass};
}

// Cost 1 everywhere.
Problem Flat() {
  return {Lattice({{"a", 0, 1000, 1}, {"b", 0, 1000, 1}}), [](const Eigen::VectorXd&) { return OneResidual(1); }};
}

// Runs over the seeds 1..n, each with an archive of its own.
struct Tally {
  int solved = 0;
  double mean_paid = 0;
  double mean_feasible = 0;
  std::int64_t most_paid = 0;
};

Tally Runs(const Problem& problem, DvhdeOptions options, int n, double target) {
  options.target_cost = target;
  Tally tally;
  for (int seed = 1; seed <= n; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    Archive archive(problem);
    tally.solved += SearchDvhde(archive, options).end == SearchEnd::kTarget;
    const EvaluationCounts& counts = archive.counts();
    tally.mean_paid += static_cast<double>(counts.paid) / n;
    tally.mean_feasible += static_cast<double>(counts.paid - counts.failed()) / n;
    tally.most_paid = std::max(tally.most_paid, counts.paid);
  }
  return tally;
}

// Every generation: its log, and a sum of hashes of all points evaluated so far, which does not depend on their order.
struct History {
  std::vector<SearchGeneration> log;
  std::vector<std::uint64_t> points;

  bool operator==(const History&) const = default;
};

History HistoryOf(const Problem& problem, const DvhdeOptions& options, int threads) {
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
DvhdeOptions Busy() {
  DvhdeOptions options;
  options.population = 12;
  options.migrate_after = 4;
  options.migrate_below_diversity = 0.3;
  options.max_evaluations = 2000;
  options.max_generations = 60;
  return options;
}

TEST(Dvhde, GivesTheSameHistoryForAnyNumberOfThreads) {
  for (const Problem& problem : {GearTrain(), Spring(1e-6)}) {
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
  const auto add = [&](const DvhdeOptions& options) {
    ++runs;
    last.insert(HistoryOf(GearTrain(), options, 1).points.back());
  };
  DvhdeOptions options = Busy();
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
    DvhdeOptions options = Busy();
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
  DvhdeOptions options = Busy();
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
  DvhdeOptions options = Busy();
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
  DvhdeOptions options;
  options.target_cost = 100;
  const SearchResult result = SearchDvhde(archive, options);
  EXPECT_EQ(result.end, SearchEnd::kTarget);
  EXPECT_LE(result.best().cost, 100);
  EXPECT_EQ(result.log.back().best_cost, result.best().cost);
  EXPECT_GT(result.log[result.log.size() - 2].best_cost, 100);
}

TEST(Dvhde, StopsWithTheBestSoFar) {
  double least = std::numeric_limits<double>::infinity();
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
  Archive archive(Spring(1e-6));
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
  DvhdeOptions options = Busy();
  options.max_generations = 20;
  const SearchResult result = SearchDvhde(archive, options);
  EXPECT_TRUE(result.candidates.empty());
  EXPECT_THROW(result.best(), std::logic_error);
  EXPECT_EQ(result.log.back().best_cost, std::numeric_limits<double>::infinity());
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
  DvhdeOptions options;
  options.max_evaluations = 10000;
  // Ten steps of the lattice.
  EXPECT_EQ(Runs({lattice, sphere}, options, 20, 1e-6).solved, 20);
}

TEST(Dvhde, ReportsCandidatesApart) {
  Archive archive(MassSpringDamper());
  DvhdeOptions options;
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

  DvhdeOptions options_;
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
  DvhdeOptions options;
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

// 100 seeds: the bands are 4 standard deviations of a binomial rate about what 1000 seeds of an independent program
// gave, 0.645 and 0.828 at 17100 and 18400 evaluations; thesis: 0.62, and 0.84 at 17053. A repair that clips solves
// 0.15, the crossover the other way round 0.26, MutationBase::kBest 0.18.
TEST(Dvhde, SolvesTheGearTrainAsOftenAsTheThesisWithItsSettings) {
  DvhdeOptions options;
  options.factor = 0.8;
  options.crossover = 0.7;
  options.forced_gene = false;
  options.simplex_iterations = 0;
  options.migrate_after = 0;
  options.max_evaluations = 40 * 1001;
  const Tally plain = Runs(GearTrain(), options, 100, kGearTarget);
  EXPECT_NEAR(plain.solved, 64.5, 19);
  // The standard deviation of one run is about 10000.
  EXPECT_NEAR(plain.mean_paid, 17100, 4 * 10000 / std::sqrt(100));

  options.forced_gene = true;
  options.migrate_after = 150;
  options.migrate_below_diversity = 0.2;
  const Tally migrating = Runs(GearTrain(), options, 100, kGearTarget);
  EXPECT_NEAR(migrating.solved, 82.8, 15.1);
  EXPECT_NEAR(migrating.mean_paid, 18400, 4 * 10000 / std::sqrt(100));
}

TEST(Dvhde, AlwaysSolvesTheGearTrainWithTheDefaults) {
  DvhdeOptions options;
  options.max_evaluations = 40000;
  const Tally tally = Runs(GearTrain(), options, 100, kGearTarget);
  EXPECT_EQ(tally.solved, 100);
  // A third of what the thesis's settings need, failures left out.
  EXPECT_LT(tally.mean_paid, 17053 / 3.0 + 4 * 4000 / std::sqrt(100));

  options.target_cost = kGearTarget;
  Archive archive(GearTrain());
  Candidate best = SearchDvhde(archive, options).best();
  EXPECT_NEAR(best.cost, 2.7008571e-12, 0.5e-19);  // printed digits
  std::sort(best.values.data(), best.values.data() + 2);
  std::sort(best.values.data() + 2, best.values.data() + 4);
  EXPECT_EQ(best.values, Eigen::Vector4d(16, 19, 43, 49));
}

// Published: 9 coils of wire 0.283 on a diameter of 1.22304, volume 2.65856.
TEST(Dvhde, AlwaysSolvesTheCoilSpringWithTheDefaults) {
  DvhdeOptions options;
  options.max_evaluations = 20000;
  const double target = 2.65865;  // prints 2.6586; the next design with another wire is 1.5 % above
  EXPECT_EQ(Runs(Spring(1e-6), options, 100, target).solved, 100);

  options.target_cost = 2.658565;
  Archive archive(Spring(1e-6));
  const Candidate best = SearchDvhde(archive, options).best();
  EXPECT_EQ(best.values[0], 9);
  EXPECT_EQ(kWires_in.at(static_cast<std::size_t>(best.values[1]) - 1), 0.283);
  EXPECT_NEAR(best.values[2], 1.22304, 0.5e-5);  // printed digits
}

// Thesis: 57 % for these settings. 4 standard deviations of a binomial rate of 200.
TEST(Dvhde, SolvesTheCoilSpringAsOftenAsTheThesisWithItsSettings) {
  DvhdeOptions options;
  options.base = MutationBase::kBest;
  options.factor = 0.9;
  options.crossover = 0.9;
  options.forced_gene = false;
  options.simplex_iterations = 0;
  options.migrate_after = 0;
  options.max_evaluations = 40 * 1001;
  EXPECT_NEAR(Runs(Spring(1e-12), options, 200, 2.65865).solved, 114, 28);
}

TEST(Dvhde, IdentifiesMassSpringAndDamper) {
  DvhdeOptions options;
  options.max_evaluations = 5000;
  const Tally tally = Runs(MassSpringDamper(), options, 50, 1e-6);
  EXPECT_EQ(tally.solved, 50);

  options.target_cost = 1e-6;
  Archive archive(MassSpringDamper());
  const Candidate best = SearchDvhde(archive, options).best();
  // A cost of 1e-6 is a thousandth of a standard deviation, and that is at most 1 % of each parameter here.
  const Eigen::Vector3d truth(200, 15000, 1500);
  EXPECT_LT(((best.values - truth).array() / truth.array()).abs().maxCoeff(), 1e-5);
}

TEST(Dvhde, IdentifiesMassSpringAndDamperByEveryMutation) {
  for (const auto base : {MutationBase::kRandom, MutationBase::kBest}) {
    for (const auto rule : {MutationFactor::kConstant, MutationFactor::kPerGeneration, MutationFactor::kPerGene}) {
      DvhdeOptions options;
      options.base = base;
      options.factor_rule = rule;
      options.factor = 0.7;
      options.max_evaluations = 10000;
      EXPECT_GE(Runs(MassSpringDamper(), options, 10, 1e-3).solved, 9);
    }
  }
}

// Thesis, ch. 5: 20 members, factor 0.7, crossover 0.8, migration below 0.1, acceleration below 10 % by 5 iterations; a
// gene differs from 5 % on (ch. 2); 150 generations (appendix A).
TEST(Dvhde, ThesisSettingsAreThoseOfTheThesis) {
  const DvhdeOptions options = ThesisDvhde();
  EXPECT_NO_THROW(options.Validate());
  EXPECT_EQ(options.population, 20);
  EXPECT_EQ(options.base, MutationBase::kBest);
  EXPECT_EQ(options.factor_rule, MutationFactor::kConstant);
  EXPECT_EQ(options.factor, 0.7);
  EXPECT_EQ(options.crossover, 0.8);
  EXPECT_FALSE(options.forced_gene);
  EXPECT_EQ(options.simplex_iterations, 5);
  EXPECT_EQ(options.accelerate_below, 0.1);
  EXPECT_EQ(options.migrate_after, 150);
  EXPECT_EQ(options.migrate_below_diversity, 0.1);
  EXPECT_EQ(options.diversity_measure, DiversityMeasure::kIndex);
  EXPECT_EQ(options.gene_difference, 0.05);
  EXPECT_EQ(options.max_generations, 150);
}

// With them migration sets in before the search has settled: it comes near, a cost of 1 being a standard deviation, and
// no nearer than that.
TEST(Dvhde, ThesisSettingsComeNearMassSpringAndDamper) {
  DvhdeOptions options = ThesisDvhde();
  options.max_evaluations = 5000;
  EXPECT_GE(Runs(MassSpringDamper(), options, 50, 1).solved, 45);
  EXPECT_LE(Runs(MassSpringDamper(), options, 50, 1e-3).solved, 5);
  options.migrate_below_diversity = 0;
  EXPECT_GE(Runs(MassSpringDamper(), options, 50, 1e-3).solved, 45);
}

struct BadOption {
  const char* message;
  void (*spoil)(DvhdeOptions& options);
};

std::ostream& operator<<(std::ostream& out, const BadOption& fault) { return out << fault.message; }

class DvhdeBadOption : public testing::TestWithParam<BadOption> {};

TEST_P(DvhdeBadOption, IsNamedBeforeAnythingIsEvaluated) {
  DvhdeOptions options;
  GetParam().spoil(options);
  Archive archive(Flat());
  EXPECT_THAT([&] { SearchDvhde(archive, options); }, ThrowsMessage<std::invalid_argument>(StrEq(GetParam().message)));
  EXPECT_EQ(archive.counts().paid, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Dvhde, DvhdeBadOption,
    testing::Values(
        BadOption{"population = 3, must be 4 or more", [](DvhdeOptions& o) { o.population = 3; }},
        BadOption{"factor = 0, must be in (0, 2]", [](DvhdeOptions& o) { o.factor = 0; }},
        BadOption{"factor = 2.1, must be in (0, 2]", [](DvhdeOptions& o) { o.factor = 2.1; }},
        BadOption{"factor = nan, must be in (0, 2]", [](DvhdeOptions& o) { o.factor = std::nan(""); }},
        BadOption{"crossover = 1.1, must be in [0, 1]", [](DvhdeOptions& o) { o.crossover = 1.1; }},
        BadOption{"simplex_iterations = -1, must be 0 or more", [](DvhdeOptions& o) { o.simplex_iterations = -1; }},
        BadOption{"accelerate_below = -0.1, must be in [0, 1]", [](DvhdeOptions& o) { o.accelerate_below = -0.1; }},
        BadOption{"migrate_after = -1, must be 0 or more", [](DvhdeOptions& o) { o.migrate_after = -1; }},
        BadOption{"migrate_below_diversity = 1.5, must be in [0, 1]",
                  [](DvhdeOptions& o) { o.migrate_below_diversity = 1.5; }},
        BadOption{"gene_difference = 1, must be in (0, 1)", [](DvhdeOptions& o) { o.gene_difference = 1; }},
        BadOption{"max_evaluations = 0, must be 1 or more", [](DvhdeOptions& o) { o.max_evaluations = 0; }},
        BadOption{"max_generations = -1, must be 0 or more", [](DvhdeOptions& o) { o.max_generations = -1; }},
        BadOption{"target_cost = -1, must be 0 or more", [](DvhdeOptions& o) { o.target_cost = -1; }},
        BadOption{"candidates = 0, must be 1 or more", [](DvhdeOptions& o) { o.candidates = 0; }},
        BadOption{"candidate_separation = 1, must be in [0, 1)", [](DvhdeOptions& o) { o.candidate_separation = 1; }}));

TEST(Dvhde, EndsHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const SearchEnd end : {SearchEnd::kNotRun, SearchEnd::kTarget, SearchEnd::kEvaluations, SearchEnd::kGenerations,
                              SearchEnd::kStopped}) {
    names.insert(SearchEndName(end));
  }
  EXPECT_EQ(names.size(), 5u);
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace fourpost
