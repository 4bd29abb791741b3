#include "vehicles/condensed/preload_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::preload_map_test {
namespace {

/// Springs left and right, front and rear, under a body whose heave, roll and pitch they hold; up positive.
Eigen::MatrixXd FourCorners() {
  constexpr double kFrontX = 1.2;
  constexpr double kRearX = -1.5;
  constexpr double kHalfTrack = 0.7;
  Eigen::MatrixXd holders(3, 4);
  holders.row(0).setOnes();
  holders.row(1) << kHalfTrack, -kHalfTrack, kHalfTrack, -kHalfTrack;
  holders.row(2) << -kFrontX, -kFrontX, -kRearX, -kRearX;
  return holders;
}

TEST(PreloadMap, OfEqualSpringsSharesAlike) {
  const PreloadMap map(Eigen::MatrixXd::Constant(1, 2, 1));
  EXPECT_FALSE(map.IsDeterminate());
  const Eigen::VectorXd preloads = map.At(Eigen::VectorXd::Constant(1, 100), Eigen::Vector2d(3, 3));
  EXPECT_NEAR(preloads[0], -50, 1e-13);  // rounding
  EXPECT_NEAR(preloads[1], -50, 1e-13);
}

// The body on its springs: a roll moment turns all of them by one angle.
TEST(PreloadMap, TransfersLoadByRollStiffness) {
  const PreloadMap map(FourCorners());
  const Eigen::VectorXd preloads = map.At(Eigen::Vector3d(0, 1000, 0), Eigen::Vector4d(26e3, 26e3, 80e3, 80e3));
  // Moment / (2 half track) = 714.3 N of transfer.
  const double transfer = 1000 / 1.4;
  EXPECT_NEAR(preloads[0], -transfer * 26 / 106, 1e-10);  // rounding
  EXPECT_NEAR(preloads[1], transfer * 26 / 106, 1e-10);
  EXPECT_NEAR(preloads[2], -transfer * 80 / 106, 1e-10);
  EXPECT_NEAR(preloads[3], transfer * 80 / 106, 1e-10);
}

// What H p + w = 0 leaves open is settled by energy: no other solution has less.
TEST(PreloadMap, HasTheLeastStrainEnergy) {
  const Eigen::MatrixXd holders = FourCorners();
  const Eigen::Vector4d rates(20e3, 35e3, 50e3, 90e3);
  const Eigen::Vector3d force(-5000, 300, -800);
  const Eigen::VectorXd preloads = PreloadMap(holders).At(force, rates);
  EXPECT_LT((holders * preloads + force).norm(), 1e-11);  // rounding of 5 kN
  const auto energy = [&](const Eigen::VectorXd& p) { return 0.5 * p.cwiseAbs2().dot(rates.cwiseInverse()); };
  const Eigen::Vector4d twist(1, -1, -1, 1);
  ASSERT_EQ((holders * twist).norm(), 0);
  for (const double step : {-1.0, 1.0}) EXPECT_LT(energy(preloads), energy(preloads + step * twist));
}

// Lengths that grow with the root of the force: l = (sqrt(1 + 4 q p / k) - 1) / (2 q). With the rates p / l the linear
// map finds the same preloads.
TEST(PreloadMap, FollowsRatesThatFollowThePreloads) {
  constexpr double q = 10;
  const Eigen::MatrixXd holders = FourCorners();
  const Eigen::Vector4d rates(60e3, 95e3, 110e3, 150e3);
  const Eigen::Vector3d force(-16000, 900, -800);
  const PreloadMap map(holders);
  const auto root = [&](const Eigen::VectorXd& p, Eigen::Index i) { return std::sqrt(1 + 4 * q * p[i] / rates[i]); };
  const Eigen::VectorXd preloads = map.At(force, [&](const Eigen::VectorXd& p) {
    HolderTangents now{Eigen::VectorXd(4), Eigen::VectorXd(4)};
    for (Eigen::Index i = 0; i < 4; ++i) {
      now.rates[i] = rates[i] * root(p, i);
      now.slack[i] = p[i] - now.rates[i] * (root(p, i) - 1) / (2 * q);
    }
    return now;
  });
  EXPECT_LT((holders * preloads + force).norm(), 1e-10);  // rounding of 16 kN
  Eigen::Vector4d secants;
  for (Eigen::Index i = 0; i < 4; ++i) secants[i] = preloads[i] * 2 * q / (root(preloads, i) - 1);
  EXPECT_LT((map.At(force, secants) - preloads).norm(), 1e-9);
  EXPECT_GT((map.At(force, rates) - preloads).norm(), 10);
}

TEST(PreloadMap, OfADeterminateBodyDoesNotAskRates) {
  const PreloadMap map(FourCorners().leftCols(3));
  EXPECT_TRUE(map.IsDeterminate());
  const Eigen::Vector3d force(-5000, 300, -800);
  EXPECT_EQ(map.At(force, Eigen::Vector3d(1, 2, 3)), map.At(force, Eigen::Vector3d::Zero()));
}

TEST(PreloadMap, LeavesToASpringWithoutRateWhatNoOtherTakes) {
  Eigen::MatrixXd holders(2, 3);
  holders << 1, 1, 0, 0, 0, 1;
  const Eigen::VectorXd preloads = PreloadMap(holders).At(Eigen::Vector2d(100, 10), Eigen::Vector3d(5, 0, 0));
  EXPECT_NEAR(preloads[0], -100, 100e-6);  // the share that it takes nevertheless
  EXPECT_NEAR(preloads[1], 0, 100e-6);
  EXPECT_NEAR(preloads[2], -10, 1e-14);
  const Eigen::VectorXd alike = PreloadMap(holders).At(Eigen::Vector2d(100, 10), Eigen::Vector3d::Zero());
  EXPECT_NEAR(alike[0], alike[1], 1e-13);
}

TEST(PreloadMap, MayHaveNothingToSet) {
  const PreloadMap map(Eigen::MatrixXd(2, 0));
  EXPECT_EQ(map.At(Eigen::Vector2d(1, 2), Eigen::VectorXd()).size(), 0);
}

}  // namespace
}  // namespace fourpost::preload_map_test
