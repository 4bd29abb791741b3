// How often and how dearly dvHDE finds optima that are known.
#include "identify/search/dvhde.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "tests/identify/test_problems.h"

namespace fourpost::dvhde_success_test {
namespace {

/// Differential evolution without what dvHDE adds, for the thesis's 1000 generations of 40.
DvhdeSearch BareEvolution() {
  DvhdeSearch options;
  options.forced_gene = false;
  options.rank_violations = false;
  options.simplex_iterations = 0;
  options.migrate_after = 0;
  options.max_evaluations = 40 * 1001;
  return options;
}

// 100 seeds: the bands are 4 standard deviations of a binomial rate about what 1000 seeds of an independent program
// gave, 0.645 and 0.828 at 17100 and 18400 evaluations; thesis: 0.62, and 0.84 at 17053. A repair that clips solves
// 0.15, the crossover the other way round 0.26, MutationBase::kBest 0.18.
TEST(DvhdeSuccess, SolvesTheGearTrainAsOftenAsTheThesisWithItsSettings) {
  DvhdeSearch options = BareEvolution();
  options.factor = 0.8;
  options.crossover = 0.7;
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

TEST(DvhdeSuccess, AlwaysSolvesTheGearTrainWithTheDefaults) {
  DvhdeSearch options(DvhdeOptions{});
  options.max_evaluations = 40000;
  const Tally tally = Runs(GearTrain(), options, 100, kGearTarget);
  EXPECT_EQ(tally.solved, 100);
  // 1000 other seeds: 2129 of a standard deviation of 1500 a run; thesis: 17053, failures left out.
  EXPECT_NEAR(tally.mean_paid, 2129, 4 * 1500 / std::sqrt(100));

  options.target_cost = kGearTarget;
  Archive archive(GearTrain());
  Candidate best = SearchDvhde(archive, options).best();
  EXPECT_NEAR(best.cost, 2.7008571e-12, 0.5e-19);  // printed digits
  std::sort(best.values.data(), best.values.data() + 2);
  std::sort(best.values.data() + 2, best.values.data() + 4);
  EXPECT_EQ(best.values, Eigen::Vector4d(16, 19, 43, 49));
}

// Published: 9 coils of wire 0.283 on a diameter of 1.22304, volume 2.65856.
TEST(DvhdeSuccess, AlwaysSolvesTheCoilSpringWithTheDefaults) {
  DvhdeSearch options(DvhdeOptions{});
  options.max_evaluations = 20000;
  const double target = 2.65865;  // prints 2.6586; the next design with another wire is 1.5 % above
  const Tally tally = Runs(CoilSpring(1e-6), options, 100, target);
  EXPECT_EQ(tally.solved, 100);
  // 1000 other seeds: 1179 of a standard deviation of 800 a run.
  EXPECT_NEAR(tally.mean_paid, 1179, 4 * 800 / std::sqrt(100));

  options.target_cost = 2.658565;
  Archive archive(CoilSpring(1e-6));
  const Candidate best = SearchDvhde(archive, options).best();
  EXPECT_EQ(best.values[0], 9);
  EXPECT_EQ(kSpringWires_in.at(static_cast<std::size_t>(best.values[1]) - 1), 0.283);
  EXPECT_NEAR(best.values[2], 1.22304, 0.5e-5);  // printed digits
}

// Thesis: 57 % for these settings. 4 standard deviations of a binomial rate of 200.
TEST(DvhdeSuccess, SolvesTheCoilSpringAsOftenAsTheThesisWithItsSettings) {
  DvhdeSearch options = BareEvolution();
  options.base = MutationBase::kBest;
  options.factor = 0.9;
  options.crossover = 0.9;
  EXPECT_NEAR(Runs(CoilSpring(1e-12), options, 200, 2.65865).solved, 114, 28);
}

// Thesis: 99 % with migration. It does not tell below which diversity; 0.05 is the reading here.
TEST(DvhdeSuccess, SolvesTheCoilSpringWithMigrationAsTheThesis) {
  DvhdeSearch options = BareEvolution();
  options.base = MutationBase::kBest;
  options.factor = 0.9;
  options.crossover = 0.9;
  options.migrate_below_diversity = 0.05;
  options.diversity_measure = DiversityMeasure::kIndex;
  options.max_evaluations = 100000;
  // 1000 other seeds: 99.4 %; 4 standard deviations of a binomial rate of 100.
  EXPECT_GE(Runs(CoilSpring(1e-12), options, 100, 2.65865).solved, 96);
}

TEST(DvhdeSuccess, IdentifiesMassSpringAndDamper) {
  DvhdeSearch options(DvhdeOptions{});
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

TEST(DvhdeSuccess, IdentifiesMassSpringAndDamperByEveryMutation) {
  for (const auto base : {MutationBase::kRandom, MutationBase::kBest}) {
    for (const auto rule : {MutationFactor::kConstant, MutationFactor::kPerGeneration, MutationFactor::kPerGene}) {
      DvhdeSearch options;
      options.base = base;
      options.factor_rule = rule;
      options.factor = 0.7;
      options.max_evaluations = 10000;
      EXPECT_GE(Runs(MassSpringDamper(), options, 10, 1e-3).solved, 9);
    }
  }
}

// Thesis, ch. 5: 20 members, factor 0.7, crossover 0.8, migration below 0.1, acceleration below 10 % by 5 iterations; a
// gene differs from 5 % on (ch. 2).
TEST(DvhdeSuccess, ThesisSettingsAreThoseOfTheThesis) {
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
  EXPECT_FALSE(options.rank_violations);
}

// With them migration sets in before the search has settled: it comes near, a cost of 1 being a standard deviation, and
// no nearer than that.
TEST(DvhdeSuccess, ThesisSettingsComeNearMassSpringAndDamper) {
  DvhdeSearch options(ThesisDvhde());
  options.max_evaluations = 5000;
  EXPECT_GE(Runs(MassSpringDamper(), options, 50, 1).solved, 45);
  EXPECT_LE(Runs(MassSpringDamper(), options, 50, 1e-3).solved, 5);
  options.migrate_below_diversity = 0;
  EXPECT_GE(Runs(MassSpringDamper(), options, 50, 1e-3).solved, 45);
}

}  // namespace
}  // namespace fourpost::dvhde_success_test
