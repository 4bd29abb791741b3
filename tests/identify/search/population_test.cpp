#include "identify/search/population.h"

#include <gtest/gtest.h>

namespace fourpost::population_test {
namespace {

const Score kFailure = {0, Failure::kNotFinite};

TEST(Population, BestAndWorstGoByCostAndAFailureIsWorst) {
  const Population population = {{{1}, {3}}, {{2}, {1}}, {{3}, kFailure}, {{4}, {5}}};
  EXPECT_EQ(BestIndex(population), 1u);
  EXPECT_EQ(WorstIndex(population), 2u);
}

TEST(Population, OfEqualsTheFirstCounts) {
  const Population population = {{{1}, {2}}, {{2}, {1}}, {{3}, {1}}, {{4}, {2}}};
  EXPECT_EQ(BestIndex(population), 1u);
  EXPECT_EQ(WorstIndex(population), 0u);
}

class PopulationDiversity : public testing::Test {
 protected:
  double Of(const Population& population, DiversityMeasure measure, double tolerance = 0.05) const {
    return Diversity(population, lattice_, measure, tolerance);
  }

  // 101 and 1001 values.
  const Lattice lattice_{{{"a", 0, 100, 1}, {"b", 0, 1000, 1}}};
};

TEST_F(PopulationDiversity, IsZeroForAllAlikeAndOneForAllDifferent) {
  EXPECT_EQ(Of({{{50, 500}, {1}}, {{50, 500}, {2}}}, DiversityMeasure::kRange), 0);
  EXPECT_EQ(Of({{{50, 500}, {1}}, {{90, 900}, {2}}, {{10, 100}, {3}}}, DiversityMeasure::kRange), 1);
}

// The best is the second; from it the genes of the others are (+5, +51), (-6, 0) steps away. A twentieth of the ranges
// is 5 and 50 steps, of the best's indices 2 and 20.
TEST_F(PopulationDiversity, CountsGenesBeyondTheToleranceFromTheBest) {
  const Population population = {{{45, 451}, {2}}, {{40, 400}, {1}}, {{34, 400}, {3}}};
  EXPECT_EQ(Of(population, DiversityMeasure::kRange), 0.5);
  EXPECT_EQ(Of(population, DiversityMeasure::kIndex), 0.75);
  EXPECT_EQ(Of(population, DiversityMeasure::kRange, 0.06), 0);
  EXPECT_EQ(Of(population, DiversityMeasure::kIndex, 0.14), 0.25);
}

TEST_F(PopulationDiversity, ByIndexIsBiasedWhereTheBestIndexIsSmall) {
  const Population low = {{{1, 1}, {1}}, {{2, 2}, {2}}};
  const Population high = {{{100, 1000}, {1}}, {{99, 999}, {2}}};
  EXPECT_EQ(Of(low, DiversityMeasure::kIndex), 1);
  EXPECT_EQ(Of(high, DiversityMeasure::kIndex), 0);
  EXPECT_EQ(Of(low, DiversityMeasure::kRange), 0);
}

}  // namespace
}  // namespace fourpost::population_test
