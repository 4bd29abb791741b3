#include "tests/closed_form/full_car.h"

#include <gtest/gtest.h>

namespace fourpost::full_car_test {
namespace {

using Vector7d = Eigen::Vector<double, 7>;

/// No two numbers alike, and no symmetry.
FullCar LopsidedCar() {
  return {.sprung_mass = 1700,
          .roll_inertia = 620,
          .pitch_inertia = 2600,
          .offset = 0.03,
          .stiffness = {38e3, 41e3, 52e3, 57e3},
          .tyre_stiffness = {330e3, 350e3, 370e3, 400e3},
          .front = {.mass = 200,
                    .roll_inertia = 70,
                    .offset = -0.02,
                    .x = 1.45,
                    .spring_station = 0.47,
                    .damper_station = 0.45,
                    .tyre_station = 0.74,
                    .damper = {1200, 3300}},
          .rear = {.mass = 240,
                   .roll_inertia = 85,
                   .offset = 0.01,
                   .x = -1.34,
                   .spring_station = 0.5,
                   .damper_station = 0.485,
                   .tyre_station = 0.75,
                   .damper = {1600, 3900}}};
}

/// Central differences of the acceleration by one of its arguments. It is linear in each, a bilinear damper that passes
/// through rest at its mean rate: any step serves, and a large one loses fewest digits.
template <typename F>
Eigen::MatrixXd RelativeDifferences(int size, F acceleration) {
  Eigen::MatrixXd matrix(7, size);
  for (int j = 0; j < size; ++j) {
    const Eigen::VectorXd step = Eigen::VectorXd::Unit(size, j);
    matrix.col(j) = (acceleration(step) - acceleration(-step)) / 2;
  }
  return matrix;
}

void ExpectEqual(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected) {
  // Rounding of sums of forces that partly cancel.
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-14 * expected.cwiseAbs().maxCoeff());
}

TEST(FullCar, ModelHasTheDerivativesOfTheAcceleration) {
  const FullCar car = LopsidedCar();
  const CondensedModel model = car.Model();
  const Vector7d rest = Vector7d::Zero();
  const Eigen::Vector4d level = Eigen::Vector4d::Zero();
  ExpectEqual(model.mass * RelativeDifferences(7, [&](const Vector7d& q) { return car.Acceleration(q, rest, level); }),
              -model.stiffness);
  Eigen::MatrixXd damping = model.damping;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots)
    damping += dashpot.law.MeanRate() * dashpot.direction * dashpot.direction.transpose();
  ExpectEqual(
      model.mass * RelativeDifferences(7, [&](const Vector7d& rate) { return car.Acceleration(rest, rate, level); }),
      -damping);
  ExpectEqual(
      model.mass * RelativeDifferences(4, [&](const Eigen::Vector4d& z) { return car.Acceleration(rest, rest, z); }),
      model.post_stiffness);
}

TEST(FullCar, DampersTellBumpFromRebound) {
  const FullCar car = LopsidedCar();
  const CondensedModel model = car.Model();
  const Vector7d rate(-0.1, 0.2, 0.3, -0.4, 0.25, 0.15, -0.35);
  Vector7d force = Vector7d::Zero();
  bool rebound = false;
  bool bump = false;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) {
    const double extension_rate = dashpot.direction.dot(rate);
    (extension_rate > 0 ? rebound : bump) = true;
    force -= dashpot.direction * dashpot.law.Force(extension_rate);
  }
  EXPECT_TRUE(rebound && bump);
  ExpectEqual(model.mass * car.Acceleration(Vector7d::Zero(), rate, Eigen::Vector4d::Zero()), force);
}

// The thesis's appendix C by one corner: lifting the front left post pushes the axle up and its left side up.
TEST(FullCar, ALiftedPostPushesItsCornerUp) {
  const FullCar car = LopsidedCar();
  const Vector7d acceleration = car.Acceleration(Vector7d::Zero(), Vector7d::Zero(), {0.01, 0, 0, 0});
  Vector7d expected = Vector7d::Zero();
  expected[3] = 330e3 * 0.01 / 200;
  expected[4] = 330e3 * 0.01 * (0.74 + 0.02) / 70;
  ExpectEqual(acceleration, expected);
}

}  // namespace
}  // namespace fourpost::full_car_test
