#include "vehicles/multibody/small_turn.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::small_turn_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d kAxis = Vector3d(0.3, -0.7, 0.5).normalized();

Matrix3d Turn(double angle) { return AngleAxisd(angle, kAxis).toRotationMatrix(); }

TEST(SmallTurn, IsTwiceTheSineOfHalfTheAngleAboutTheAxis) {
  for (const double angle : {0.0, 1e-9, 0.01, 0.5, -0.5, 2.0, 3.0})
    EXPECT_LT((SmallTurn(Turn(angle)).value - 2 * std::sin(angle / 2) * kAxis).norm(), 1e-15) << angle;
}

TEST(SmallTurn, DiffersFromTheAngleByA24thOfItsCube) {
  const double angle = 0.1;
  // The next term, angle^5 / 1920, is a 80 000th of the difference.
  EXPECT_NEAR((angle - SmallTurn(Turn(angle)).value.norm()) / std::pow(angle, 3), 1.0 / 24, 1e-5);
}

TEST(SmallTurn, HasTheRateOfAnAngularVelocityInTheAxesThatStand) {
  constexpr double kStep = 1e-6;
  for (const double angle : {0.0, 0.3, -1.0, 2.5})
    for (const Vector3d& w : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0.2, -0.5, 1)}) {
      const auto turned = [&](double t) {
        const Matrix3d by = AngleAxisd(t * w.norm(), w.normalized()).toRotationMatrix();
        return SmallTurn(by * Turn(angle)).value;
      };
      const Vector3d rate = (turned(kStep) - turned(-kStep)) / (2 * kStep);
      // Rounding over the step, truncation 1e-12.
      EXPECT_LT((SmallTurn(Turn(angle)).rate * w - rate).norm(), 1e-9) << angle;
    }
}

}  // namespace
}  // namespace fourpost::small_turn_test
