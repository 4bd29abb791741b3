#include "identify/run/addition_round.h"

#include <string>

#include <gmock/gmock.h>

namespace fourpost::addition_round_test {
namespace {

SuggestedAddition Suggested(const std::string& mechanism, double cost, double worth) {
  return {.addition = {.mechanism = mechanism, .elements = {}, .words = mechanism},
          .cost = cost,
          .effective = 100,
          .worth = worth};
}

// Of 100 residuals and a cost of 1000.
const GrowthRound kRound{.residuals = 100, .tried = 100};

Suggestions Found(std::vector<SuggestedAddition> list) {
  Suggestions found;
  found.cost = 1000;
  found.list = std::move(list);
  return found;
}

// The mount lowers the cost most alone, because it imitates the two others, beside which it is worth nothing.
TEST(AdditionRound, TriesWhatIsWorthMostBesideTheOthers) {
  const Suggestions found =
      Found({Suggested("mount", 400, 0), Suggested("part", 500, -20), Suggested("tyres", 600, -30)});
  EXPECT_THAT(WorthTrying(found, kRound, {}), testing::ElementsAre(2u, 1u, 0u));
}

TEST(AdditionRound, TriesTheOthersByWhatTheyAreWorthAlone) {
  const Suggestions found = Found({Suggested("mount", 500, 0), Suggested("part", 400, 0), Suggested("gas", 1000, 0)});
  EXPECT_THAT(WorthTrying(found, kRound, {}), testing::ElementsAre(1u, 0u));
  EXPECT_THAT(WorthTrying(found, kRound, {"part"}), testing::ElementsAre(0u));
}

TEST(AdditionRound, TriesTwoOfAMechanismAndFourInAll) {
  const Suggestions found =
      Found({Suggested("friction", 100, 0), Suggested("friction", 110, 0), Suggested("friction", 120, 0),
             Suggested("mount", 130, 0), Suggested("gas", 140, 0), Suggested("part", 150, 0)});
  EXPECT_THAT(WorthTrying(found, kRound, {}), testing::ElementsAre(0u, 1u, 3u, 4u));
}

// Closed form: 100 ln 0.84 + ln 100 + 2 ln 100 = -3.6, and 2 ln 100 = 9.2 for another choice.
TEST(AdditionRound, ChargesForEachChoice) {
  Suggestions found = Found({Suggested("mount", 840, 0)});
  EXPECT_THAT(WorthTrying(found, kRound, {}), testing::ElementsAre(0u));
  found.list.front().addition.choices = 2;
  EXPECT_THAT(WorthTrying(found, kRound, {}), testing::IsEmpty());
}

}  // namespace
}  // namespace fourpost::addition_round_test
