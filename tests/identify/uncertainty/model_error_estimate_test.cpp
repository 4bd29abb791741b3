#include "identify/uncertainty/model_error_estimate.h"

#include <cmath>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::model_error_estimate_test {
namespace {

constexpr Eigen::Index kClusters = 4;
constexpr Eigen::Index kEach = 100;

/// One parameter, the mean of all; each cluster off by its own.
FittedResiduals Fitted(const Eigen::VectorXd& offsets, double noise, std::uint64_t seed) {
  RandomStream draws(seed, "noise");
  FittedResiduals fitted;
  fitted.jacobian = Eigen::MatrixXd::Ones(kClusters * kEach, 1);
  fitted.priors.resize(0, 1);
  fitted.weights = Eigen::VectorXd::Ones(kClusters * kEach);
  fitted.is_relative = {true};
  Eigen::VectorXd residuals(kClusters * kEach);
  for (Eigen::Index i = 0; i < residuals.size(); ++i) residuals[i] = offsets[i / kEach] + noise * draws.Normal();
  residuals.array() -= residuals.mean();
  fitted.scores = residuals;
  return fitted;
}

ResidualStructure Structure() {
  ResidualStructure structure;
  structure.partitions = {{"parts", {}, {}}};
  for (Eigen::Index g = 0; g < kClusters; ++g) {
    structure.partitions[0].Add(std::to_string(g), kEach);
    structure.series.push_back({.first = g * kEach, .count = kEach, .step = 1});
  }
  return structure;
}

ModelErrorEstimate EstimateOf(const FittedResiduals& fitted) {
  return EstimateModelError(
      fitted, Structure(),
      ResidualNoise(fitted.scores.col(0), Structure(), Eigen::MatrixXd::Zero(fitted.scores.rows(), 1)));
}

// Without cluster g the mean of the others, in the sense of residuals: -mean of g's residuals over the others' number.
TEST(ModelErrorEstimate, MovesAsTheFitWithoutAClusterWould) {
  const Eigen::Vector4d offsets(-3, -1, 1, 3);
  const ModelErrorEstimate estimate = EstimateOf(Fitted(offsets, 1e-6, 1));
  ASSERT_EQ(estimate.ways.size(), 1U);
  for (Eigen::Index g = 0; g < kClusters; ++g)
    EXPECT_NEAR(estimate.ways[0].shifts(0, g), offsets[g] / (kClusters - 1), 1e-5);
  // (G - 1) / G sum of squares: 3 / 4 of 20 / 9; Student's t of three degrees of freedom.
  EXPECT_NEAR(estimate.reach[0], kErrorInCommon * 3.18245 * std::sqrt(0.75 * 20 / 9), 1e-4);
  EXPECT_TRUE(estimate.is_significant);
}

TEST(ModelErrorEstimate, TakesNoiseForNoise) {
  double disagreement = 0;
  double degrees = 0;
  int significant = 0;
  constexpr int kTimes = 400;
  for (int k = 0; k < kTimes; ++k) {
    const ModelErrorEstimate estimate = EstimateOf(Fitted(Eigen::Vector4d::Zero(), 1, static_cast<std::uint64_t>(k)));
    disagreement += estimate.ways[0].disagreement;
    degrees += estimate.ways[0].degrees;
    significant += estimate.is_significant;
  }
  // Four degrees of freedom a time: a deviation of 3.5 %; variances by second differences add some.
  EXPECT_NEAR(disagreement / degrees, 1, 0.15);
  EXPECT_EQ(significant, 0);
}

TEST(ModelErrorEstimate, NamesRecordingsThatContradictTheRest) {
  ResidualStructure structure = Structure();
  structure.recordings.Add("sines", 3 * kEach);
  structure.recordings.Add("sweep", kEach);
  const auto by_recording = [&](double offset) {
    const FittedResiduals fitted = Fitted(Eigen::Vector4d(0, 0, 0, offset), 1, 2);
    return EstimateModelError(
               fitted, structure,
               ResidualNoise(fitted.scores.col(0), structure, Eigen::MatrixXd::Zero(fitted.scores.rows(), 1)))
        .by_recording;
  };
  const Eigen::VectorXd any = Eigen::VectorXd::Zero(1);
  EXPECT_TRUE(by_recording(0).Contradictions(any).empty());
  const PartedData parted = by_recording(2);
  const std::vector<Contradiction> found = parted.Contradictions(any);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(parted.Contradictions(Eigen::VectorXd::Constant(1, 2)).empty());
  // Means of 300 and 100 samples of deviation 1 that differ by 2: both shifts are multiples of one difference, whose
  // deviation is (1/300 + 1/100)^1/2; what noise is taken for scatters by 15 %.
  const double deviations = 2 / std::sqrt(4.0 / 300);
  for (const Contradiction& one : found) EXPECT_NEAR(one.deviations / deviations, 1, 0.2);
  for (const Contradiction& one : found)
    EXPECT_NEAR(one.shift, one.cluster == 1 ? 0.5 : -1.5, 0.35);  // of the mean, without the last and with it alone
}

TEST(ModelErrorEstimate, SubtractsWhatNoiseMovesByItself) {
  const FittedResiduals noise = Fitted(Eigen::Vector4d::Zero(), 1, 3);
  const ModelErrorEstimate estimate = EstimateOf(noise);
  const PartedData& way = estimate.ways[0];
  EXPECT_LT(way.BeyondNoise().squaredNorm(), way.shifts.squaredNorm());
  // The mean of 300 samples less that of all 400: variances 1/300 - 1/400.
  for (Eigen::Index g = 0; g < kClusters; ++g)
    EXPECT_NEAR(way.by_noise(0, g) / std::sqrt(1.0 / 300 - 1.0 / 400), 1, 0.2);
}

// Two ways of the same clusters have the variance of one and twice its degrees of freedom.
TEST(ModelErrorEstimate, AddsDegreesOfFreedomOfWays) {
  ResidualStructure structure = Structure();
  structure.partitions.push_back(structure.partitions[0]);
  const FittedResiduals fitted = Fitted(Eigen::Vector4d(-3, -1, 1, 3), 1e-6, 1);
  const ModelErrorEstimate estimate = EstimateModelError(
      fitted, structure,
      ResidualNoise(fitted.scores.col(0), structure, Eigen::MatrixXd::Zero(fitted.scores.rows(), 1)));
  EXPECT_NEAR(estimate.reach[0], kErrorInCommon * 2.44691 * std::sqrt(0.75 * 20 / 9), 1e-4);
}

// What two of three clusters hold nothing of stays where it is, and the third is named.
TEST(ModelErrorEstimate, LeavesWhatRestsOnOneCluster) {
  FittedResiduals fitted = Fitted(Eigen::Vector4d(-3, -1, 1, 3), 1, 1);
  fitted.jacobian.conservativeResize(Eigen::NoChange, 2);
  fitted.jacobian.col(1).setConstant(1e-3);
  fitted.jacobian.col(1).tail(kEach).setLinSpaced(-1, 1);
  fitted.scores = fitted.scores.col(0).asDiagonal() * fitted.jacobian;
  fitted.is_relative = {true, true};
  const ModelErrorEstimate estimate = EstimateModelError(
      fitted, Structure(),
      ResidualNoise(fitted.scores.col(0), Structure(), Eigen::MatrixXd::Zero(fitted.scores.rows(), 1)));
  EXPECT_EQ(estimate.ways[0].rests_on[0], -1);
  EXPECT_EQ(estimate.ways[0].rests_on[1], kClusters - 1);
  EXPECT_LT(std::abs(estimate.ways[0].shifts(1, kClusters - 1)), 0.1);
}

TEST(ModelErrorEstimate, LearnsNothingFromTwoClusters) {
  ResidualStructure structure = Structure();
  structure.partitions[0] = {"parts", {}, {}};
  structure.partitions[0].Add("a", 2 * kEach);
  structure.partitions[0].Add("b", 2 * kEach);
  const FittedResiduals fitted = Fitted(Eigen::Vector4d(-1, -1, 1, 1), 0.1, 1);
  const ModelErrorEstimate estimate = EstimateModelError(
      fitted, structure,
      ResidualNoise(fitted.scores.col(0), structure, Eigen::MatrixXd::Zero(fitted.scores.rows(), 1)));
  EXPECT_FALSE(estimate.is_significant);
  EXPECT_EQ(estimate.ways[0].shifts.size(), 0);
}

}  // namespace
}  // namespace fourpost::model_error_estimate_test
