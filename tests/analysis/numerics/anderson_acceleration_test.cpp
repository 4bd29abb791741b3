#include "analysis/numerics/anderson_acceleration.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

namespace fourpost::anderson_acceleration_test {
namespace {

/// Distance from the fixed point of x <- a x + b after some steps from zero.
double ErrorAfter(int steps, int history, const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d solution = (Eigen::Matrix3d::Identity() - a).inverse() * b;
  AndersonAcceleration acceleration(history);
  Eigen::VectorXd x = Eigen::Vector3d::Zero();
  for (int k = 0; k < steps; ++k) x = acceleration.Next(x, a * x + b - x);
  return (x - solution).norm();
}

Eigen::Matrix3d Contraction() { return Eigen::Matrix3d{{0.5, 0.2, 0}, {-0.1, 0.3, 0.4}, {0, 0.1, -0.6}}; }

// As GMRES does; a plain step starts, the fourth combines three differences.
TEST(AndersonAcceleration, SolvesThreeLinearEquationsInFourSteps) {
  const Eigen::Vector3d b(1, 2, -1);
  EXPECT_GT(ErrorAfter(3, 3, Contraction(), b), 1e-3);
  // Rounding, times the condition of three differences.
  EXPECT_LT(ErrorAfter(4, 3, Contraction(), b), 1e-12);
}

TEST(AndersonAcceleration, ConvergesWhereThePlainIterationDiverges) {
  const Eigen::Vector3d b(1, 2, -1);
  const Eigen::Matrix3d a = -4 * Contraction();
  EXPECT_GT(ErrorAfter(20, 0, a, b), 1e3);
  EXPECT_LT(ErrorAfter(4, 3, a, b), 1e-12);
}

TEST(AndersonAcceleration, WithoutHistoryIsThePlainIteration) {
  const Eigen::Vector3d b(1, 2, -1);
  AndersonAcceleration acceleration(0);
  const Eigen::VectorXd once = acceleration.Next(Eigen::Vector3d::Zero(), b);
  EXPECT_EQ(once, b);
  EXPECT_EQ(acceleration.Next(once, 0.5 * b), Eigen::VectorXd(1.5 * b));
}

TEST(AndersonAcceleration, RestsInTheFixedPoint) {
  AndersonAcceleration acceleration(2);
  const Eigen::VectorXd x = Eigen::Vector3d(1, 2, 3);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(acceleration.Next(x, Eigen::Vector3d::Zero()), x);
}

}  // namespace
}  // namespace fourpost::anderson_acceleration_test
