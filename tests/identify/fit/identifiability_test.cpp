#include "identify/fit/identifiability.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/fit/findings.h"
#include "tests/identify/shipped_study.h"

namespace fourpost::identifiability_test {
namespace {

LoadedStudy WithoutForces() {
  LoadedStudy study = ShippedStudy();
  Rest(study).loads.clear();
  for (MeasuredRun& run : Sines(study).runs) std::erase_if(run.channels, [](const auto& c) { return c.unit == "N"; });
  return study;
}

Identifiability Before(const LoadedStudy& study) {
  const VehicleObjective objective = study.MakeObjective();
  Archive archive(objective.MakeProblem(), 2);
  const auto before = IdentifiabilityBefore(archive, objective, 1);
  EXPECT_TRUE(before.has_value());
  return *before;
}

TEST(Identifiability, ForcesDetermineAllOfTheLandRover) {
  const Identifiability before = Before(ShippedStudy());
  EXPECT_FALSE(before.HasUndetermined());
  EXPECT_EQ(before.covariance.rank, 12);
  EXPECT_EQ(before.weakest.size(), 1u);
}

// All accelerations and strut motions are ratios: every mass, rate and damping times 1.01 changes none of them.
TEST(Identifiability, AccelerationsLeaveExactlyTheCommonScaleOpen) {
  const Identifiability before = Before(WithoutForces());
  ASSERT_EQ(before.covariance.rank, 11);
  const Eigen::VectorXd open = before.covariance.directions.col(11);
  // Differences of slopes of the balance: a hundredth.
  for (const double component : open) EXPECT_NEAR(component, 1 / std::sqrt(12), 0.01);
  EXPECT_EQ(UnidentifiedAs(open).id(), kScaleUnidentified.id());
}

// Heave and pitch turn a body about its length by nothing but what is not alike on both sides.
TEST(Identifiability, RollInertiaNeedsRollExcitation) {
  LoadedStudy study = ShippedStudy("model3");
  const Identifiability with = Before(study);
  std::erase_if(Sines(study).runs, [](const MeasuredRun& run) { return run.name == "roll"; });
  ASSERT_EQ(Sines(study).runs.size(), 2U);
  const Identifiability without = Before(study);
  EXPECT_THAT(without.weakest.at(0), testing::HasSubstr("_roll"));
  EXPECT_GT(without.covariance.condition, 5 * with.covariance.condition);
}

TEST(Identifiability, OneKnownMassClosesTheScale) {
  LoadedStudy study = WithoutForces();
  study.vehicle.parameters[study.free[0]].prior_sd = 10;
  EXPECT_FALSE(Before(study).HasUndetermined());
}

// A car's lengths have no part in it.
TEST(Identifiability, TheScaleOfMostParametersWantsAForce) {
  Eigen::VectorXd direction(7);
  direction << 0.45, 0.44, 0.46, 0.43, 0.45, 0, 0.02;
  EXPECT_EQ(UnidentifiedAs(direction).id(), kScaleUnidentified.id());
  EXPECT_EQ(UnidentifiedAs(-direction).id(), kScaleUnidentified.id());
  direction[1] = -0.44;
  EXPECT_EQ(UnidentifiedAs(direction).id(), kDirectionUnidentified.id());
}

TEST(Identifiability, OfAFewParametersTheRemedyIsNoForce) {
  EXPECT_EQ(UnidentifiedAs(Eigen::Vector<double, 6>(0.6, 0.58, 0.55, 0, 0, 0.05).eval()).id(), kScaleUnidentified.id());
  EXPECT_EQ(UnidentifiedAs(Eigen::Vector<double, 7>(0.6, 0.58, 0.55, 0, 0, 0.05, 0).eval()).id(),
            kDirectionUnidentified.id());
  EXPECT_EQ(UnidentifiedAs(Eigen::Vector3d(0.8, -0.6, 0)).id(), kDirectionUnidentified.id());
}

}  // namespace
}  // namespace fourpost::identifiability_test
