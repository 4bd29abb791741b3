#include "identify/search/dvhde_operators.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::dvhde_operators_test {
namespace {

using testing::ElementsAre;

Draws Stream(std::size_t individual = 0) { return Draws(1, DrawPurpose::kTrial, 0, individual); }

// Draws are fixed by the seed; bounds on frequencies are 4 standard deviations of the binomial distribution.
double FourSd(double share, int draws) { return 4 * std::sqrt(share * (1 - share) / draws); }

TEST(DvhdeOperators, RandomPointsAreEvenOverEachAxis) {
  const Lattice lattice({{"a", 0, 1, 1}, {"b", 0, 9, 1}});
  Draws draws = Stream();
  const int n = 10000;
  std::array<int, 2> a = {};
  std::array<int, 10> b = {};
  for (int i = 0; i < n; ++i) {
    const LatticePoint point = RandomPoint(lattice, draws);
    ASSERT_TRUE(lattice.Contains(point));
    ++a[static_cast<std::size_t>(point[0] - 1)];
    ++b[static_cast<std::size_t>(point[1] - 1)];
  }
  for (const int count : a) EXPECT_NEAR(count / double{n}, 0.5, FourSd(0.5, n));
  for (const int count : b) EXPECT_NEAR(count / double{n}, 0.1, FourSd(0.1, n));
}

TEST(DvhdeOperators, PicksThreeOthersEvenly) {
  Draws draws = Stream();
  const int n = 10000;
  std::array<std::array<int, 6>, 3> counts = {};
  for (int i = 0; i < n; ++i) {
    const auto picks = PickThree(6, 2, draws);
    ASSERT_EQ((std::set<std::size_t>{2, picks[0], picks[1], picks[2]}.size()), 4u);
    for (std::size_t k = 0; k < 3; ++k) ++counts[k].at(picks[k]);
  }
  for (const auto& count : counts) {
    EXPECT_EQ(count[2], 0);
    for (const std::size_t i : {0, 1, 3, 4, 5}) EXPECT_NEAR(count[i] / double{n}, 0.2, FourSd(0.2, n));
  }
}

TEST(DvhdeOperators, PicksThreeOfTheSmallestPopulation) {
  Draws draws = Stream();
  const auto picks = PickThree(4, 3, draws);
  EXPECT_THAT((std::set<std::size_t>(picks.begin(), picks.end())), ElementsAre(0, 1, 2));
}

TEST(DvhdeOperators, MutantIsBasePlusRoundedScaledDifference) {
  // 0.7 * 12 = 8.4, 0.7 * -12 = -8.4, 0.5 * 3 = 1.5, 0.5 * -3 = -1.5
  EXPECT_THAT(Mutate({10, 10, 10, 10}, {20, 8, 5, 2}, {8, 20, 2, 5}, {0.7, 0.7, 0.5, 0.5}), ElementsAre(18, 2, 12, 8));
}

TEST(DvhdeOperators, MutantMayLeaveTheLattice) {
  EXPECT_THAT(Mutate({2, 9}, {1, 9}, {9, 1}, {1, 1}), ElementsAre(-6, 17));
}

TEST(DvhdeOperators, CrossoverOfRateZeroIsTheParentAndOfRateOneTheMutant) {
  Draws draws = Stream();
  for (int i = 0; i < 100; ++i) {
    EXPECT_THAT(Cross({1, 2, 3}, {7, 8, 9}, 0, false, draws), ElementsAre(1, 2, 3));
    EXPECT_THAT(Cross({1, 2, 3}, {7, 8, 9}, 1, false, draws), ElementsAre(7, 8, 9));
    EXPECT_THAT(Cross({1, 2, 3}, {7, 8, 9}, 1, true, draws), ElementsAre(7, 8, 9));
  }
}

TEST(DvhdeOperators, CrossoverTakesEachGeneFromTheMutantWithItsRate) {
  Draws draws = Stream();
  const int n = 10000;
  std::array<int, 3> from_mutant = {};
  for (int i = 0; i < n; ++i) {
    const LatticePoint trial = Cross({0, 0, 0}, {1, 1, 1}, 0.8, false, draws);
    for (std::size_t j = 0; j < 3; ++j) from_mutant[j] += trial[j] == 1;
  }
  for (const int count : from_mutant) EXPECT_NEAR(count / double{n}, 0.8, FourSd(0.8, n));
}

TEST(DvhdeOperators, ForcedGeneIsExactlyOneAndAnyOfThem) {
  Draws draws = Stream();
  const int n = 10000;
  std::array<int, 3> from_mutant = {};
  for (int i = 0; i < n; ++i) {
    const LatticePoint trial = Cross({0, 0, 0}, {1, 1, 1}, 0, true, draws);
    ASSERT_EQ(std::count(trial.begin(), trial.end(), 1), 1);
    for (std::size_t j = 0; j < 3; ++j) from_mutant[j] += trial[j] == 1;
  }
  for (const int count : from_mutant) EXPECT_NEAR(count / double{n}, 1 / 3.0, FourSd(1 / 3.0, n));
}

TEST(DvhdeOperators, RepairLeavesLegalGenesAlone) {
  const Lattice lattice({{"a", 0, 9, 1}, {"b", 0, 9, 1}});
  Draws draws = Stream();
  LatticePoint point = {1, 10};
  Repair(lattice, point, draws);
  EXPECT_THAT(point, ElementsAre(1, 10));
}

TEST(DvhdeOperators, RepairReplacesAnIllegalGeneByAnyLegalOne) {
  const Lattice lattice({{"a", 0, 9, 1}, {"b", 0, 9, 1}, {"c", 0, 9, 1}});
  Draws draws = Stream();
  const int n = 10000;
  std::array<int, 10> low = {};
  std::array<int, 10> high = {};
  for (int i = 0; i < n; ++i) {
    LatticePoint point = {0, 4, 11};
    Repair(lattice, point, draws);
    ASSERT_TRUE(lattice.Contains(point));
    ASSERT_EQ(point[1], 4);
    ++low[static_cast<std::size_t>(point[0] - 1)];
    ++high[static_cast<std::size_t>(point[2] - 1)];
  }
  for (const int count : low) EXPECT_NEAR(count / double{n}, 0.1, FourSd(0.1, n));
  for (const int count : high) EXPECT_NEAR(count / double{n}, 0.1, FourSd(0.1, n));
}

TEST(DvhdeOperators, SelectionIsGreedy) {
  const Score failure = {0, Failure::kNotConverged};
  const auto survivor = [](const Score& parent, const Score& trial) {
    Individual individual = {{1}, parent};
    Select(individual, {{2}, trial});
    return individual.point[0];
  };
  EXPECT_EQ(survivor({2}, {1}), 2);
  EXPECT_EQ(survivor({1}, {2}), 1);
  EXPECT_EQ(survivor({1}, {1}), 1);
  EXPECT_EQ(survivor(failure, {9}), 2);
  EXPECT_EQ(survivor({9}, failure), 1);
  EXPECT_EQ(survivor(failure, failure), 1);
}

// Eq. 2.6 for a best index of 26 of 101: with probability 25/100 a uniform share of 25 steps down, else of 75 up. The
// mean is 26 - 12.5 / 4 + 37.5 * 3 / 4 = 51; a share below half a step rounds to none: 0.02 of those down, 1/150 up.
TEST(DvhdeOperators, ScatterFollowsTheMigrationFormula) {
  const Lattice lattice({{"a", 0, 100, 1}});
  Draws draws = Stream();
  const int n = 40000;
  int below = 0;
  int above = 0;
  double sum = 0;
  std::set<std::int64_t> reached;
  for (int i = 0; i < n; ++i) {
    const LatticePoint point = Scatter(lattice, {26}, draws);
    ASSERT_TRUE(lattice.Contains(point));
    reached.insert(point[0]);
    below += point[0] < 26;
    above += point[0] > 26;
    sum += static_cast<double>(point[0]);
  }
  EXPECT_NEAR(below / double{n}, 0.25 * 0.98, FourSd(0.245, n));
  EXPECT_NEAR(above / double{n}, 0.75 * (1 - 1 / 150.0), FourSd(0.745, n));
  // The standard deviation of one is below 30 steps.
  EXPECT_NEAR(sum / n, 51, 4 * 30 / std::sqrt(n));
  EXPECT_EQ(reached.size(), 101u);
}

TEST(DvhdeOperators, ScatterFromABoundCoversTheWholeAxisAndNoMore) {
  const Lattice lattice({{"a", 0, 4, 1}, {"b", 0, 4, 1}, {"c", 0, 1, 1}});
  Draws draws = Stream();
  std::array<std::set<std::int64_t>, 3> reached;
  for (int i = 0; i < 1000; ++i) {
    const LatticePoint point = Scatter(lattice, {1, 5, 2}, draws);
    for (std::size_t j = 0; j < 3; ++j) reached[j].insert(point[j]);
  }
  EXPECT_THAT(reached[0], ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(reached[1], ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(reached[2], ElementsAre(1, 2));
}

}  // namespace
}  // namespace fourpost::dvhde_operators_test
