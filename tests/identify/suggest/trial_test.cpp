#include "identify/suggest/trial.h"

#include <gtest/gtest.h>

namespace fourpost::trial_test {
namespace {

bool IsImitation(double amount, double cost, bool of_study = true) {
  Trial trial{.addition = {.least = -0.25, .greatest = 0.35}};
  if (of_study) trial.addition.study = [](double) { return std::string(); };
  trial.test = ScoreTest{.amount = amount, .cost = cost};
  return trial.IsImitation(100);
}

TEST(Trial, IsAnImitationAtTheEndOfAChannelsRangeUnlessItExplainsMost) {
  EXPECT_TRUE(IsImitation(0.35, 62));
  EXPECT_TRUE(IsImitation(-0.25, 62));
  EXPECT_FALSE(IsImitation(0.35, 10));
  EXPECT_FALSE(IsImitation(0.1, 62));
  EXPECT_FALSE(IsImitation(0.35, 62, false));
}

}  // namespace
}  // namespace fourpost::trial_test
