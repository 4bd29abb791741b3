#include "identify/experiments/known_answers.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace fourpost::known_answers_test {
namespace {

class KnownAnswersTest : public testing::Test {
 protected:
  double Asked(const std::vector<double>& values, const Excitation& excitation) {
    const auto solve = [this] {
      ++solved_;
      return PeriodicResponse{.unconverged_Hz = {static_cast<double>(solved_)}};
    };
    return answers_.Of(values, excitation, solve).unconverged_Hz.front();
  }

  const Excitation heave_ = {.frequency_Hz = {1, 2}, .amplitude_m = {0.01, 0.01}, .shape = {1, 1}};
  KnownAnswers answers_ = KnownAnswers({3, 4});
  int solved_ = 0;
};

TEST_F(KnownAnswersTest, SolveEachExcitationOnce) {
  EXPECT_EQ(Asked({3, 4}, heave_), 1);
  EXPECT_EQ(Asked({3, 4}, heave_), 1);
  Excitation other = heave_;
  other.amplitude_m[1] = 0.02;
  EXPECT_EQ(Asked({3, 4}, other), 2);
  other = heave_;
  other.shape[1] = -1;
  EXPECT_EQ(Asked({3, 4}, other), 3);
  EXPECT_EQ(Asked({3, 4}, heave_), 1);
}

TEST_F(KnownAnswersTest, KeepNothingOfOtherValues) {
  EXPECT_EQ(Asked({3, 5}, heave_), 1);
  EXPECT_EQ(Asked({3, 5}, heave_), 2);
  EXPECT_EQ(Asked({3, 4}, heave_), 3);
}

TEST_F(KnownAnswersTest, KeepNothingOfAFailure) {
  EXPECT_THROW(answers_.Of({3, 4}, heave_, []() -> PeriodicResponse { throw std::runtime_error("none"); }),
               std::runtime_error);
  EXPECT_EQ(Asked({3, 4}, heave_), 1);
}

}  // namespace
}  // namespace fourpost::known_answers_test
