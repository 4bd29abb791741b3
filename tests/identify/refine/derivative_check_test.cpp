#include "identify/refine/derivative_check.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::derivative_check_test {
namespace {

constexpr double kStep = 1e-3;

/// a exp(-k t) + b at t = 0, 0.1, ... 1.9.
Evaluation Decay(const Eigen::VectorXd& p) {
  Evaluation evaluation;
  evaluation.residuals.resize(20);
  for (int i = 0; i < 20; ++i) evaluation.residuals[i] = p[0] * std::exp(-p[1] * 0.1 * i) + p[2];
  return evaluation;
}

class DerivativeCheck : public testing::Test {
 protected:
  DerivativeCheck() {
    for (int i = 0; i < 20; ++i) {
      const double decay = std::exp(-values_[1] * 0.1 * i);
      jacobian_.row(i) << values_[0] * decay, -values_[1] * 0.1 * i * values_[0] * decay, values_[2];
    }
  }

  bool Holds(const Eigen::Vector3d& values) {
    Archive archive({lattice_, Decay});
    const FitVariables variables(lattice_);
    const bool holds =
        DerivativesHold(archive, variables, variables.FromValues(values), Decay(values).residuals, jacobian_, kStep);
    paid_ = archive.counts().paid;
    return holds;
  }

  const Lattice lattice_{{{"a", 0.1, 1, 0.01}, {"k", 0.1, 5, 0.01}, {"b", 0.1, 1, 0.01}}};
  const Eigen::Vector3d values_{0.6, 2, 0.4};
  /// By logarithms of the values.
  Eigen::MatrixXd jacobian_{20, 3};
  std::int64_t paid_ = 0;
};

TEST_F(DerivativeCheck, TakesFourEvaluations) {
  EXPECT_TRUE(Holds(values_));
  EXPECT_EQ(paid_, 4);
}

// Of three columns of like norms each has a third or more of the change.
TEST_F(DerivativeCheck, FindsAColumnThatIsWrong) {
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Eigen::MatrixXd right = jacobian_;
    jacobian_.col(j) *= 1.1;
    EXPECT_FALSE(Holds(values_)) << j;
    jacobian_ = right;
  }
}

// What a model's own derivatives err by, 1 % of a column, could be all of such a slope.
TEST_F(DerivativeCheck, LeavesSmallSlopesToDifferences) {
  const Eigen::MatrixXd right = jacobian_;
  jacobian_.col(1) = jacobian_.col(0) + 1e-3 * jacobian_.col(1);
  EXPECT_FALSE(Holds(values_));
  jacobian_ = right;
  jacobian_.col(2).setZero();
  EXPECT_FALSE(Holds(values_));
  EXPECT_EQ(paid_, 0);
}

// A variable at a bound takes no part. Next to one it cannot be moved, and where none can, nothing is confirmed.
TEST_F(DerivativeCheck, StaysWithinTheBounds) {
  const auto holds_at = [&](const Eigen::Vector3d& values) {
    for (int i = 0; i < 20; ++i) {
      const double decay = std::exp(-values[1] * 0.1 * i);
      jacobian_.row(i) << values[0] * decay, -values[1] * 0.1 * i * values[0] * decay, values[2];
    }
    return Holds(values);
  };
  EXPECT_TRUE(holds_at({0.6, 2, 0.1}));
  EXPECT_FALSE(holds_at({0.6, 2, 0.1 * (1 + 0.1 * kStep)}));
  EXPECT_FALSE(holds_at({0.1, 5, 1}));
}

}  // namespace
}  // namespace fourpost::derivative_check_test
