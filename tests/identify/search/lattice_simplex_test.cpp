#include "identify/search/lattice_simplex.h"

#include <functional>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::lattice_simplex_test {
namespace {

using ScorePoints = std::function<std::vector<Score>(const std::vector<LatticePoint>&)>;

// False when not all are answered; the simplex then hears nothing.
bool Answer(LatticeSimplex& simplex, const ScorePoints& score) {
  const std::vector<LatticePoint> asked = simplex.Ask();
  const std::vector<Score> scores = score(asked);
  if (scores.size() < asked.size()) return false;
  simplex.Tell(scores);
  return true;
}

Individual RunSimplex(const Population& start, const Lattice& lattice, int iterations, const ScorePoints& score) {
  LatticeSimplex simplex(lattice, start);
  while (simplex.iterations() < iterations) {
    if (!Answer(simplex, score)) break;
  }
  return simplex.best();
}

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

// Scores from a table, 100 elsewhere; remembers what was asked, and answers at most `budget` points.
class Scorer {
 public:
  explicit Scorer(std::map<LatticePoint, double> costs, std::size_t budget = 1000)
      : costs_(std::move(costs)), budget_(budget) {}

  ScorePoints Function() {
    return [this](const std::vector<LatticePoint>& points) {
      std::vector<Score> scores;
      for (const LatticePoint& point : points) {
        if (asked_.size() == budget_) break;
        asked_.push_back(point);
        const auto found = costs_.find(point);
        scores.push_back({found == costs_.end() ? 100 : found->second});
      }
      return scores;
    };
  }

  const std::vector<LatticePoint>& asked() const { return asked_; }

 private:
  std::map<LatticePoint, double> costs_;
  std::size_t budget_;
  std::vector<LatticePoint> asked_;
};

class DownhillSimplexStep : public testing::Test {
 protected:
  Individual Run(Scorer& scorer, int iterations = 1) const {
    return RunSimplex(simplex_, lattice_, iterations, scorer.Function());
  }

  const Lattice lattice_{{{"a", 1, 101, 1}, {"b", 1, 101, 1}}};
  // The centroid of the two better ones is (50, 40); the worst reflects to (50, 30) and expands to (50, 20).
  const Population simplex_ = {{{50, 50}, {9}}, {{44, 40}, {1}}, {{56, 40}, {5}}};
};

TEST_F(DownhillSimplexStep, ExpandsWhenTheReflectionIsTheBest) {
  Scorer scorer({{{50, 30}, 0.5}, {{50, 20}, 0.2}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{50, 20}));
  EXPECT_THAT(scorer.asked(), ElementsAre(LatticePoint{50, 30}, LatticePoint{50, 20}));
}

TEST_F(DownhillSimplexStep, KeepsTheReflectionWhenTheExpansionIsWorse) {
  Scorer scorer({{{50, 30}, 0.5}, {{50, 20}, 0.7}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{50, 30}));
}

TEST_F(DownhillSimplexStep, KeepsAMiddlingReflectionWithoutMore) {
  Scorer scorer({{{50, 30}, 3}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{44, 40}));
  EXPECT_THAT(scorer.asked(), ElementsAre(LatticePoint{50, 30}));
}

TEST_F(DownhillSimplexStep, ContractsOutsideWhenTheReflectionBeatsTheWorstOnly) {
  Scorer scorer({{{50, 30}, 7}, {{50, 35}, 0.5}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{50, 35}));
  EXPECT_THAT(scorer.asked(), ElementsAre(LatticePoint{50, 30}, LatticePoint{50, 35}));
}

TEST_F(DownhillSimplexStep, ContractsInsideWhenTheReflectionIsWorst) {
  Scorer scorer({{{50, 30}, 10}, {{50, 45}, 0.5}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{50, 45}));
  EXPECT_THAT(scorer.asked(), ElementsAre(LatticePoint{50, 30}, LatticePoint{50, 45}));
}

TEST_F(DownhillSimplexStep, ShrinksHalfwayToTheBestWhenNothingHelps) {
  Scorer scorer({{{50, 40}, 0.5}});
  EXPECT_EQ(Run(scorer).point, (LatticePoint{50, 40}));
  EXPECT_THAT(scorer.asked(),
              ElementsAre(LatticePoint{50, 30}, LatticePoint{50, 45}, LatticePoint{50, 40}, LatticePoint{47, 45}));
}

TEST_F(DownhillSimplexStep, StaysWithinTheBounds) {
  const Lattice narrow({{"a", 1, 101, 1}, {"b", 1, 76, 1}});
  const Population simplex = {{{2, 70}, {1}}, {{4, 72}, {5}}, {{40, 20}, {9}}};
  Scorer scorer({{{1, 76}, 0.5}});
  // The reflection is (-34, 122), the expansion beyond it.
  EXPECT_EQ(RunSimplex(simplex, narrow, 1, scorer.Function()).point, (LatticePoint{1, 76}));
  EXPECT_THAT(scorer.asked(), Each(LatticePoint{1, 76}));
}

TEST_F(DownhillSimplexStep, EndsWithTheBestWhenNoMoreIsAnswered) {
  for (std::size_t budget = 0; budget < 4; ++budget) {
    Scorer scorer({}, budget);
    EXPECT_EQ(Run(scorer, 100).point, (LatticePoint{44, 40}));
    EXPECT_EQ(scorer.asked().size(), budget);
  }
}

TEST_F(DownhillSimplexStep, DoesNothingInNoIterations) {
  Scorer scorer({});
  EXPECT_EQ(Run(scorer, 0).point, (LatticePoint{44, 40}));
  EXPECT_THAT(scorer.asked(), IsEmpty());
}

TEST(DownhillSimplex, MovesAwayFromAFailedVertex) {
  const Lattice lattice({{"a", 1, 101, 1}});
  const Population simplex = {{{60}, {0, Failure::kNotConverged}}, {{50}, {5}}};
  Scorer scorer({{{40}, 1}, {{30}, 2}});
  EXPECT_EQ(RunSimplex(simplex, lattice, 1, scorer.Function()).point, LatticePoint{40});
}

TEST(DownhillSimplex, FindsTheBottomOfABowlAndStaysOnTheLattice) {
  const Lattice lattice({{"a", 1, 1001, 1}, {"b", 1, 1001, 1}});
  const ScorePoints bowl = [&](const std::vector<LatticePoint>& points) {
    std::vector<Score> scores;
    for (const LatticePoint& point : points) {
      EXPECT_TRUE(lattice.Contains(point));
      const double a = static_cast<double>(point[0] - 700);
      const double b = static_cast<double>(point[1] - 1001);
      scores.push_back({a * a + 4 * b * b});
    }
    return scores;
  };
  Population start;
  for (const LatticePoint& point : {LatticePoint{100, 100}, {300, 100}, {100, 400}}) {
    start.push_back({point, bowl({point}).front()});
  }
  // On a lattice the simplex may collapse a few steps short: within 1 % of the range.
  const Individual found = RunSimplex(start, lattice, 100, bowl);
  EXPECT_LT(LatticeDistance(lattice, found.point, {700, 1001}), 0.01);
}

TEST(LatticeSimplex, TakesTheBestMembersAndNoneTwice) {
  const Lattice lattice({{"a", 1, 101, 1}, {"b", 1, 101, 1}});
  const Population population = {{{1, 1}, {4}}, {{2, 2}, {1}}, {{2, 2}, {1}}, {{3, 3}, {3}}, {{4, 4}, {2}}};
  const LatticeSimplex simplex(lattice, population);
  ASSERT_EQ(simplex.vertices().size(), 3u);
  EXPECT_EQ(simplex.vertices()[0].point, (LatticePoint{2, 2}));
  EXPECT_EQ(simplex.vertices()[1].point, (LatticePoint{4, 4}));
  EXPECT_EQ(simplex.vertices()[2].point, (LatticePoint{3, 3}));
}

TEST(LatticeSimplex, MakesMissingVerticesTowardsTheFurtherBound) {
  const Lattice lattice({{"a", 1, 101, 1}, {"b", 1, 101, 1}, {"c", 1, 2, 1}});
  const Population population = {{{20, 90, 2}, {1}}, {{20, 90, 2}, {1}}};
  LatticeSimplex simplex(lattice, population);
  EXPECT_THAT(simplex.Ask(), ElementsAre(LatticePoint{25, 90, 2}, LatticePoint{20, 85, 2}, LatticePoint{20, 90, 1}));
  simplex.Tell({{7}, {8}, {9}});
  ASSERT_EQ(simplex.vertices().size(), 4u);
  EXPECT_EQ(simplex.vertices()[1].score, Score{7});
  EXPECT_EQ(simplex.iterations(), 0);
}

TEST(LatticeSimplex, HasCollapsedWhenNoVertexIsFurtherThanAStep) {
  const Lattice lattice({{"a", 1, 101, 1}, {"b", 1, 101, 1}});
  EXPECT_TRUE(LatticeSimplex(lattice, {{{5, 5}, {1}}, {{6, 5}, {2}}, {{5, 4}, {3}}}).IsCollapsed());
  EXPECT_FALSE(LatticeSimplex(lattice, {{{5, 5}, {1}}, {{7, 5}, {2}}, {{5, 4}, {3}}}).IsCollapsed());
}

}  // namespace
}  // namespace fourpost::lattice_simplex_test
