#include "vehicles/multibody/tyre_foot.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace fourpost::tyre_foot_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRadius = 0.35;

/// Yaw, then lean, then pitch.
Matrix3d Turned(double yaw, double lean, double pitch) {
  return (AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(lean, Vector3d::UnitX()) *
          AngleAxisd(pitch, Vector3d::UnitY()))
      .toRotationMatrix();
}

TEST(TyreFoot, StandsBelowAnUprightWheelHoweverItIsPitchedAndYawed) {
  for (const double pitch : {0.0, 0.4, 2.0})
    EXPECT_LT((TyreFoot(Turned(0.7, 0, pitch), kRadius).offset - Vector3d(0, 0, -kRadius)).norm(), 1e-15);
}

TEST(TyreFoot, LeansWithTheWheel) {
  // The wheel's plane leans about x.
  const Vector3d offset = TyreFoot(Turned(0, 0.2, 1.0), kRadius).offset;
  EXPECT_LT((offset - kRadius * Vector3d(0, std::sin(0.2), -std::cos(0.2))).norm(), 1e-15);
}

TEST(TyreFoot, IsTheLowestPointOfTheRim) {
  const Matrix3d turn = Turned(0.3, 0.5, 0.9);
  const Vector3d offset = TyreFoot(turn, kRadius).offset;
  EXPECT_NEAR(offset.norm(), kRadius, 1e-15);
  EXPECT_NEAR(offset.dot(turn.col(1)), 0, 1e-15);
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100;
    const Vector3d rim = kRadius * (turn * Vector3d(std::cos(angle), 0, std::sin(angle)));
    EXPECT_LE(offset.z(), rim.z() + 1e-15);
  }
}

TEST(TyreFoot, HasTheRateOfAnAngularVelocity) {
  constexpr double kStep = 1e-6;
  const Matrix3d turn = Turned(0.3, 0.5, 0.9);
  for (const Vector3d& w : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1), Vector3d(0.2, -0.5, 1)}) {
    const auto offset = [&](double t) {
      return TyreFoot(AngleAxisd(t * w.norm(), w.normalized()).toRotationMatrix() * turn, kRadius).offset;
    };
    const Vector3d rate = (offset(kStep) - offset(-kStep)) / (2 * kStep);
    EXPECT_LT((TyreFoot(turn, kRadius).rate * w - rate).norm(), 1e-9);  // rounding over the step
  }
}

TEST(TyreFoot, IsThePointItselfWithoutRadius) {
  const TyreFoot foot(Turned(0.3, 0.5, 0.9), 0);
  EXPECT_EQ(foot.offset, Vector3d(0, 0, 0));
  EXPECT_EQ(foot.rate, Matrix3d(Matrix3d::Zero()));
}

}  // namespace
}  // namespace fourpost::tyre_foot_test
