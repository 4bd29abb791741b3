#include "identify/run/growth_judgement.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "identify/run/take_back.h"
#include "identify/suggest/score_test.h"

namespace fourpost::growth_judgement_test {
namespace {

GrowthStep Judged(const GrowthStep& before, GrowthStep step) {
  Judge(before, step);
  return step;
}

TEST(GrowthJudgement, AsksForACriterionThatFallsAndNoWorsePrediction) {
  const GrowthStep before{.misfit = 3, .validation_percent = 10};
  EXPECT_TRUE(Judged(before, {.criterion = -1, .validation_percent = 10.1}).is_kept);
  EXPECT_FALSE(Judged(before, {.criterion = 0, .validation_percent = 5}).is_kept);
  EXPECT_FALSE(Judged(before, {.criterion = -1, .validation_percent = 11}).is_kept);
  EXPECT_FALSE(Judged(before, {.criterion = -1, .validation_percent = 5, .at_bound = {"k"}}).is_kept);
  EXPECT_TRUE(Judged({.misfit = 3, .validation_percent = NAN}, {.criterion = -1, .validation_percent = NAN}).is_kept);
}

/// Within the stated errors a fall of the cost alone says nothing of what is real.
TEST(GrowthJudgement, AsksForABetterPredictionOfWhatTheStatedErrorsExplain) {
  const GrowthStep before{.misfit = 0.8, .validation_percent = 10};
  EXPECT_FALSE(Judged(before, {.criterion = -1, .validation_percent = 9.95}).is_kept);
  EXPECT_TRUE(Judged(before, {.criterion = -1, .validation_percent = 9.85}).is_kept);
  EXPECT_TRUE(Judged(before, {.takes_back = "steps/1", .criterion = -1, .validation_percent = 10}).is_kept);
}

GrowthPath PathOf(std::vector<GrowthStep> steps) { return {.study = "", .state = "", .steps = std::move(steps)}; }

TEST(GrowthJudgement, PrefersABoundToAWorsePredictionWhereNothingElseHolds) {
  const GrowthStep before{.misfit = 3, .validation_percent = 10, .is_kept = true};
  const GrowthStep worse{.criterion = -9, .validation_percent = 20};
  const GrowthStep at_bound{.criterion = -1, .validation_percent = 10, .at_bound = {"k"}};
  EXPECT_EQ(BestThatStoodBack(PathOf({before, worse, at_bound})), 2u);
  EXPECT_EQ(BestThatStoodBack(PathOf({before, {.criterion = -5, .validation_percent = 15}, worse})), 2u);
  EXPECT_EQ(BestThatStoodBack(PathOf({before, {.criterion = 2, .validation_percent = 5}})), std::nullopt);
  EXPECT_EQ(BestThatStoodBack(PathOf({before, {.cost = NAN, .criterion = -9, .validation_percent = 5}})), std::nullopt);
  // Of a fit that the stated errors explain nothing is far off.
  EXPECT_EQ(BestThatStoodBack(PathOf({{.misfit = 0.9, .validation_percent = 10, .is_kept = true}, worse})),
            std::nullopt);
}

TEST(GrowthJudgement, GoesBackWhereADetourLedToNoBetterPrediction) {
  const GrowthStep good{.validation_percent = 10, .is_kept = true};
  const GrowthStep worse{.validation_percent = 20, .is_kept = true};
  const GrowthStep refused{.validation_percent = 2};
  EXPECT_EQ(BestPredicted(PathOf({worse, good, refused, worse})), 1u);
  EXPECT_EQ(BestPredicted(PathOf({worse, worse, good, refused})), 2u);
  EXPECT_EQ(BestPredicted(PathOf({good, {.validation_percent = 10.1, .is_kept = true}})), 1u);
  EXPECT_EQ(BestPredicted(
                PathOf({{.validation_percent = NAN, .is_kept = true}, {.validation_percent = NAN, .is_kept = true}})),
            1u);
}

/// Else an addition could come and go for ever.
TEST(GrowthJudgement, TakesBackWhatItWouldNotAdd) {
  const GrowthStep with{.cost = 100, .effective = 200, .residuals = 50, .tried = 30};
  for (const int choices : {1, 2})
    for (const double without : {101.0, 107.0, 112.0, 120.0})
      EXPECT_EQ(TakeBackChange(with, without, {.count = 2, .choices = choices}) < 0,
                CriterionChange(without, 100, 50, 200, 2, 30, choices) > 0)
          << without;
  EXPECT_LT(TakeBackChange(with, 101, {.count = 2}), 0);
  EXPECT_GT(TakeBackChange(with, 120, {.count = 2}), 0);
  // What two choices bring goes more easily than what one brings.
  EXPECT_LT(TakeBackChange(with, 112, {.count = 2, .choices = 2}), 0);
}

}  // namespace
}  // namespace fourpost::growth_judgement_test
