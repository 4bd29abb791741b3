#include "identify/search/elites.h"

#include <gmock/gmock.h>

namespace fourpost::elites_test {
namespace {

std::vector<double> Costs(const Elites& elites) {
  std::vector<double> costs;
  for (const Individual& individual : elites.best()) costs.push_back(individual.score.cost);
  return costs;
}

TEST(Elites, AreTheBestDistinctPoints) {
  Elites elites(3);
  for (const double cost : {5.0, 1.0, 4.0, 1.0, 2.0}) elites.Add({{static_cast<std::int64_t>(cost)}, {.cost = cost}});
  EXPECT_THAT(Costs(elites), testing::ElementsAre(1, 2, 4));
}

TEST(Elites, MayHaveOneCost) {
  Elites elites(3);
  elites.Add({{1}, {.cost = 1}});
  elites.Add({{2}, {.cost = 1}});
  elites.Add({{1}, {.cost = 1}});
  EXPECT_EQ(elites.best().size(), 2);
}

TEST(Elites, AreNoneWhereNoneAreKept) {
  Elites elites(0);
  elites.Add({{1}, {.cost = 1}});
  EXPECT_TRUE(elites.best().empty());
}

TEST(Elites, BeginAnew) {
  Elites elites(2);
  elites.Add({{1}, {.cost = 1}});
  elites.Clear();
  EXPECT_TRUE(elites.best().empty());
}

}  // namespace
}  // namespace fourpost::elites_test
