#include "identify/search/pattern_search.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fourpost::pattern_search_test {
namespace {

using testing::ElementsAre;

const Lattice& Square() {
  static const Lattice lattice({{"a", 1, 100, 1}, {"b", 1, 100, 1}});
  return lattice;
}

/// Least at (40, 70).
Score ScoreOf(const LatticePoint& point) {
  return {.cost = std::pow(static_cast<double>(point[0] - 40), 2) + std::pow(static_cast<double>(point[1] - 70), 2)};
}

std::vector<LatticePoint> Walked(PatternSearch& search) {
  std::vector<LatticePoint> asked;
  while (search.Ask()) {
    asked.push_back(*search.Ask());
    search.Tell(ScoreOf(asked.back()));
  }
  return asked;
}

Individual From(LatticePoint point) { return {point, ScoreOf(point)}; }

TEST(PatternSearch, GoesOnInGrowingStepsWhileTheyHelp) {
  PatternSearch search(Square(), From({10, 70}), {{.axis = 0, .step = 4, .growth = 2}});
  EXPECT_THAT(Walked(search),
              ElementsAre(LatticePoint{14, 70}, LatticePoint{22, 70}, LatticePoint{38, 70}, LatticePoint{70, 70}));
  EXPECT_THAT(search.best().point, ElementsAre(38, 70));
  ASSERT_EQ(search.ended().size(), 1);
  EXPECT_TRUE(search.ended()[0].helped);
}

TEST(PatternSearch, TurnsRoundWhereTheFirstStepDoesNotHelp) {
  PatternSearch search(Square(), From({50, 70}), {{.axis = 0, .step = 8, .growth = 1}});
  EXPECT_THAT(Walked(search), ElementsAre(LatticePoint{58, 70}, LatticePoint{42, 70}, LatticePoint{34, 70}));
  EXPECT_THAT(search.best().point, ElementsAre(42, 70));
}

TEST(PatternSearch, EndsWhereNeitherWayHelps) {
  PatternSearch search(Square(), From({40, 70}), {{.axis = 0, .step = 3, .growth = 2}});
  EXPECT_EQ(Walked(search).size(), 2);
  EXPECT_FALSE(search.ended()[0].helped);
  EXPECT_THAT(search.best().point, ElementsAre(40, 70));
}

TEST(PatternSearch, StaysOnTheLatticeAndAsksForNoPointTwice) {
  PatternSearch search(Square(), From({1, 100}), {{.axis = 1, .step = 500, .growth = 1}});
  EXPECT_THAT(Walked(search), ElementsAre(LatticePoint{1, 1}));
}

TEST(PatternSearch, WalksAxesInTurn) {
  PatternSearch search(Square(), From({41, 69}), {{.axis = 0, .step = 1}, {.axis = 1, .step = 1}});
  Walked(search);
  EXPECT_THAT(search.best().point, ElementsAre(40, 70));
}

TEST(PatternSearch, AsksForItsOwnStartWhereThatHasNoScore) {
  PatternSearch search(Square(), LatticePoint{39, 70}, {{.axis = 0, .step = 1}});
  EXPECT_THAT(Walked(search), ElementsAre(LatticePoint{39, 70}, LatticePoint{40, 70}, LatticePoint{41, 70}));
}

}  // namespace
}  // namespace fourpost::pattern_search_test
