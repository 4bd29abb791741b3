#include "tests/peers/peer_objective.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>

namespace fourpost::peer_objective_test {
namespace {

using testing::ElementsAre;

const Lattice kTwo({{"teeth", 12, 15, 1, true}, {"mass", 1, 100, 1}});

LatticePoint At(double teeth, double mass, bool logarithmic = false) {
  return PointInCube(kTwo, std::array{teeth, mass}, logarithmic);
}

TEST(PointInCube, SplitsAnAxisIntoEqualCells) {
  EXPECT_THAT(At(0, 0), ElementsAre(1, 1));
  EXPECT_THAT(At(0.2499, 0.0099), ElementsAre(1, 1));
  EXPECT_THAT(At(0.2501, 0.0101), ElementsAre(2, 2));
  EXPECT_THAT(At(0.7499, 0.9899), ElementsAre(3, 99));
  EXPECT_THAT(At(1, 1), ElementsAre(4, 100));
}

TEST(PointInCube, EndsAtTheBounds) {
  EXPECT_THAT(At(-3, -1e300), ElementsAre(1, 1));
  EXPECT_THAT(At(INFINITY, 1.0001), ElementsAre(4, 100));
}

TEST(PointInCube, SpacesByRatiosWhatIsPositiveAndNotDiscrete) {
  // Half way from 1 to 100 by ratio is 10, the tenth value.
  EXPECT_THAT(At(0.5, 0.5, true), ElementsAre(3, 10));
  EXPECT_THAT(At(1, 1, true), ElementsAre(4, 100));
}

TEST(PointInCube, RefusesWhatIsNoPoint) {
  EXPECT_THROW(At(0.5, NAN), std::invalid_argument);
  EXPECT_THROW(PointInCube(kTwo, std::array{0.5}, false), std::invalid_argument);
}

TEST(PeerCost, RanksAsIsBetterDoes) {
  // Best first.
  const std::array<Score, 6> scores = {{{.cost = 0},
                                        {.cost = 1e90},
                                        {.failure = Failure::kInfeasible, .violation = 1e-9},
                                        {.failure = Failure::kInfeasible, .violation = 2},
                                        {.failure = Failure::kInfeasible, .violation = 8e6},
                                        {.failure = Failure::kNotFinite}}};
  for (std::size_t i = 0; i + 1 < scores.size(); ++i) {
    EXPECT_TRUE(IsBetter(scores[i], scores[i + 1])) << i;
    EXPECT_LT(PeerCost(scores[i]), PeerCost(scores[i + 1])) << i;
  }
  EXPECT_TRUE(std::isfinite(PeerCost(scores.back())));
}

}  // namespace
}  // namespace fourpost::peer_objective_test
