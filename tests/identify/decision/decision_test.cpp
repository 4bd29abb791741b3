#include "identify/decision/decision.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "identify/search/draws.h"

namespace fourpost::decision_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::ElementsAre;

double Below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double Density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); }

VectorXd Normals(Index count, std::uint64_t seed) {
  VectorXd values(count);
  for (Index i = 0; i < count; ++i)
    values[i] = Draws(seed, DrawPurpose::kNoise, 0, static_cast<std::size_t>(i)).Normal();
  return values;
}

// Of two settings whose difference is normal, the better one is the best with Phi(mean / sd), and its expected regret
// is sd phi(mean / sd) - mean Phi(-mean / sd).
TEST(Decision, HasTheClosedFormsOfTwoNormalAlternatives) {
  constexpr Index kDraws = 40000;
  constexpr double kMean = 0.7;
  constexpr double kSd = 1.5;
  MatrixXd cost(2, kDraws);
  cost.row(0) = Normals(kDraws, 1).transpose();
  cost.row(1) = cost.row(0) + (kMean + kSd * Normals(kDraws, 2).array()).matrix().transpose();
  const Decision decision = Decide(cost, {true, true});
  EXPECT_EQ(decision.best, 0U);
  // Four standard errors of so many draws.
  const double p = Below(kMean / kSd);
  EXPECT_NEAR(decision.best_probability[0], p, 4 * std::sqrt(p * (1 - p) / kDraws));
  EXPECT_NEAR(decision.best_probability.sum(), 1, 1e-9);
  const double regret = kSd * Density(kMean / kSd) - kMean * Below(-kMean / kSd);
  EXPECT_NEAR(decision.regret[0], regret, 4 * kSd / std::sqrt(kDraws));
  EXPECT_NEAR(decision.regret[1], regret + kMean, 8 * kSd / std::sqrt(kDraws));
  EXPECT_NEAR(decision.difference_sd[1], kSd, 4 * kSd / std::sqrt(2.0 * kDraws));
  EXPECT_NEAR(decision.lower[1], kMean - 1.95996 * kSd, 0.06);
  EXPECT_NEAR(decision.upper[1], kMean + 1.95996 * kSd, 0.06);
  EXPECT_THAT(decision.is_indistinct, ElementsAre(true, true));
}

// What all settings of a car share does not count: the intervals of each would overlap by far.
TEST(Decision, IsOfPairedDifferences) {
  MatrixXd cost(3, 50);
  const VectorXd shared = 100 * Normals(50, 3);
  const VectorXd own = Normals(50, 4);
  cost.row(0) = shared.transpose();
  cost.row(1) = (shared.array() + 0.1).matrix().transpose();
  cost.row(2) = (shared + own).transpose().array() + 0.5;
  const Decision decision = Decide(cost, {true, true, true});
  EXPECT_EQ(decision.best, 0U);
  EXPECT_THAT(decision.is_indistinct, ElementsAre(true, false, true));
  EXPECT_EQ(decision.IndistinctCount(), 2U);
  EXPECT_EQ(decision.Rival(), 2U);
  // Rounding beside the shared part.
  EXPECT_NEAR(decision.difference_sd[1], 0, 1e-12);
  MatrixXd alone = cost;
  alone.rowwise() -= shared.transpose();
  EXPECT_TRUE(Decide(alone, {true, true, true}).best_probability.isApprox(decision.best_probability));
}

TEST(Decision, SharesADrawAmongEquals) {
  MatrixXd cost(3, 2);
  cost << 1, 1, 1, 2, 2, 1;
  const Decision decision = Decide(cost, {true, true, true});
  EXPECT_EQ(decision.best, 0U);
  EXPECT_THAT(decision.best_probability, ElementsAre(0.5, 0.25, 0.25));
  EXPECT_THAT(decision.regret, ElementsAre(0, 0.5, 0.5));
}

TEST(Decision, LeavesOutWhatIsNotAdmitted) {
  MatrixXd cost(3, 2);
  cost << 0, 0, 1, 1, 2, 2;
  const Decision decision = Decide(cost, {false, true, true});
  EXPECT_EQ(decision.best, 1U);
  EXPECT_THAT(decision.best_probability, ElementsAre(0, 1, 0));
  EXPECT_THAT(decision.regret, ElementsAre(-1, 0, 1));
  EXPECT_THAT(decision.is_indistinct, ElementsAre(false, true, false));
  EXPECT_EQ(decision.Rival(), 2U);
  EXPECT_THROW(Decide(cost, {false, false, false}), std::invalid_argument);
  EXPECT_THROW(Decide(MatrixXd(3, 0), {true, true, true}), std::invalid_argument);
}

TEST(Decision, OfOneCarHasNoDoubt) {
  const Decision decision = Decide(Eigen::Vector3d(2, 1, 3), {true, true, true});
  EXPECT_EQ(decision.best, 1U);
  EXPECT_THAT(decision.best_probability, ElementsAre(0, 1, 0));
  EXPECT_THAT(decision.is_indistinct, ElementsAre(false, true, false));
  EXPECT_EQ(decision.regret[1], 0);
}

TEST(ParetoFront, IsWhatComparingAllPairsLeaves) {
  constexpr Index kCount = 200;
  VectorXd first(kCount);
  VectorXd second(kCount);
  std::vector<bool> admitted;
  Draws draws(5, DrawPurpose::kProbe, 0, 0);
  for (Index i = 0; i < kCount; ++i) {
    // Whole numbers, so that there are equals.
    first[i] = static_cast<double>(draws.Integer(0, 40));
    second[i] = static_cast<double>(draws.Integer(0, 40));
    admitted.push_back(draws.Uniform() < 0.8);
  }
  const std::vector<std::size_t> front = ParetoFront(first, second, admitted);
  std::vector<bool> is_on_front(kCount, false);
  for (const std::size_t i : front) is_on_front[i] = true;
  for (Index i = 0; i < kCount; ++i) {
    bool is_beaten = !admitted[static_cast<std::size_t>(i)];
    bool has_equal_before = false;
    for (Index j = 0; j < kCount; ++j) {
      if (!admitted[static_cast<std::size_t>(j)]) continue;
      const bool no_worse = first[j] <= first[i] && second[j] <= second[i];
      is_beaten = is_beaten || (no_worse && (first[j] < first[i] || second[j] < second[i]));
      has_equal_before = has_equal_before || (j < i && first[j] == first[i] && second[j] == second[i]);
    }
    EXPECT_EQ(is_on_front[static_cast<std::size_t>(i)], !is_beaten && !has_equal_before) << i;
  }
  for (std::size_t k = 1; k < front.size(); ++k) {
    EXPECT_LT(first[static_cast<Index>(front[k - 1])], first[static_cast<Index>(front[k])]);
    EXPECT_GT(second[static_cast<Index>(front[k - 1])], second[static_cast<Index>(front[k])]);
  }
}

}  // namespace
}  // namespace fourpost::decision_test
