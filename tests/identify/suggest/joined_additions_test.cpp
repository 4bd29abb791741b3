#include "identify/suggest/joined_additions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost {
namespace {

using Eigen::VectorXd;

/// Pays where a hundredth of the squares goes.
bool Pays(double before, const VectorXd& left, std::size_t) { return left.squaredNorm() < 0.99 * before; }

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
  const JoinedAdditions joined = JoinAdditions(before, {LeftAlone(before, b), LeftAlone(before, a)}, Pays);
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
  const JoinedAdditions joined = JoinAdditions(before, {LeftAlone(before, a), LeftAlone(before, b)}, Pays);
  EXPECT_THAT(joined.places, testing::ElementsAre(0u));
}

// What would raise the residuals is not taken with a negative share.
TEST(JoinedAdditions, TakesNoNegativeShare) {
  const VectorXd a = Wave(1);
  EXPECT_THAT(JoinAdditions(a, {2 * a}, Pays).places, testing::IsEmpty());
}

TEST(JoinedAdditions, OfNothingIsNothing) { EXPECT_TRUE(JoinAdditions(Wave(1), {}, Pays).places.empty()); }

}  // namespace
}  // namespace fourpost
