#include "identify/suggest/joined_additions.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::joined_additions_test {
namespace {

using Eigen::VectorXd;

/// Below 0 where a hundredth of the squares goes.
double Change(double before, const VectorXd& left, std::size_t) {
  return left.squaredNorm() < 1e-12 * before ? -30 : std::log(left.squaredNorm() / before) + 0.01;
}

/// Each of a thing of its own.
std::vector<OfferedAddition> Offered(const std::vector<VectorXd>& left) {
  std::vector<OfferedAddition> offered;
  for (const VectorXd& one : left) offered.push_back({one, offered.size()});
  return offered;
}

VectorXd Wave(double cycles) {
  constexpr Eigen::Index kCount = 200;
  VectorXd wave(kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) wave[i] = std::sin(cycles * 0.05 * static_cast<double>(i));
  return wave;
}

/// Alone each takes its direction out, and what it shares with the other.
VectorXd LeftAlone(const VectorXd& before, const VectorXd& direction) {
  return before - before.dot(direction) / direction.squaredNorm() * direction;
}

TEST(JoinedAdditions, SharesWhatBothExplain) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(1.3);  // correlated
  const VectorXd before = 3 * a + 2 * b;
  const JoinedAdditions joined = JoinAdditions(before, Offered({LeftAlone(before, b), LeftAlone(before, a)}), Change);
  ASSERT_EQ(joined.places.size(), 2u);
  EXPECT_EQ(joined.places[0], 1u);
  // Closed form: alone they would be 3 + 2 a.b/a.a and 2 + 3 a.b/b.b.
  EXPECT_NEAR(joined.shares[0], 3 / (3 + 2 * a.dot(b) / a.squaredNorm()), 1e-6);
  EXPECT_NEAR(joined.shares[1], 2 / (2 + 3 * a.dot(b) / b.squaredNorm()), 1e-6);
}

TEST(JoinedAdditions, LeavesOutWhatDoesNotPay) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(7);
  const VectorXd before = 3 * a + 0.2 * b + 3 * Wave(23);
  const JoinedAdditions joined = JoinAdditions(before, Offered({LeftAlone(before, a), LeftAlone(before, b)}), Change);
  EXPECT_THAT(joined.places, testing::ElementsAre(0u));
}

// The one of many numbers explains more, but not as much more as its numbers cost.
TEST(JoinedAdditions, TakesWhatPaysThoughAnotherExplainsMore) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(7);
  const VectorXd before = 3 * a + 2.5 * b + Wave(23);
  const auto change = [](double squares, const VectorXd& left, std::size_t place) {
    return 200 * std::log(left.squaredNorm() / squares) + (place == 0 ? 600 : 5);
  };
  const JoinedAdditions joined = JoinAdditions(before, Offered({LeftAlone(before, a), LeftAlone(before, b)}), change);
  EXPECT_THAT(joined.places, testing::ElementsAre(1u));
}

// Alone the imitation explains 3/4, each of the two things that are missing half; beside both it explains nothing.
TEST(JoinedAdditions, LeavesOutWhatImitatedOthersOnceTheseAreTaken) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(7);
  const VectorXd imitation = a + b + 0.8 * Wave(13);
  const VectorXd before = 3 * a + 3 * b + 0.1 * Wave(23);
  const JoinedAdditions joined = JoinAdditions(
      before, Offered({LeftAlone(before, imitation), LeftAlone(before, a), LeftAlone(before, b)}), Change);
  EXPECT_THAT(joined.places, testing::UnorderedElementsAre(1u, 2u));
}

// Alone the first alternative explains 5/6 and the other half; beside what else is missing the other all.
TEST(JoinedAdditions, TakeOfAlternativesTheOneThatIsRightBesideTheOthers) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(7);
  const VectorXd imitation = a + 0.5 * b + 0.3 * Wave(13);
  const VectorXd before = 3 * a + 3 * b + 0.1 * Wave(23);
  const JoinedAdditions joined = JoinAdditions(
      before, {{LeftAlone(before, imitation), 0}, {LeftAlone(before, a), 0}, {LeftAlone(before, b), 1}}, Change);
  EXPECT_THAT(joined.places, testing::UnorderedElementsAre(1u, 2u));
}

// Closed form of nearly orthogonal waves: without one of them its squares remain, to what waves of 200 points have in
// common.
TEST(JoinedAdditions, AreWorthWhatRemainsWithoutThem) {
  const VectorXd a = Wave(1);
  const VectorXd b = Wave(7);
  const VectorXd c = Wave(23);
  const VectorXd before = 3 * a + 2 * b + c;
  const JoinedAdditions joined = JoinAdditions(before, Offered({LeftAlone(before, a), LeftAlone(before, b)}), Change);
  ASSERT_THAT(joined.places, testing::ElementsAre(0u, 1u));
  EXPECT_NEAR(joined.worth[0], std::log(1.0 / 10) + 0.01, 0.1);
  EXPECT_NEAR(joined.worth[1], std::log(1.0 / 5) + 0.01, 0.1);
}

// What would raise the residuals is not taken with a negative share.
TEST(JoinedAdditions, TakesNoNegativeShare) {
  const VectorXd a = Wave(1);
  EXPECT_THAT(JoinAdditions(a, Offered({2 * a}), Change).places, testing::IsEmpty());
}

TEST(JoinedAdditions, OfNothingIsNothing) { EXPECT_TRUE(JoinAdditions(Wave(1), {}, Change).places.empty()); }

}  // namespace
}  // namespace fourpost::joined_additions_test
