#include "identify/experiments/kinematics/kinematic_residuals.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"
#include "identify/fit/fit.h"
#include "tests/identify/experiments/kinematics/rig_study.h"

namespace fourpost::kinematic_residuals_test {
namespace {

using rig_study::kBall_m;
using rig_study::kBush_Npm;
using rig_study::kTie_m;

/// Poses to 1e-11 m and rad over the least noise, 0.003 deg, and rounding of their digits in degrees.
constexpr double kZero = 1e-5;

TEST(KinematicResiduals, AreZeroAtTheTruthOfACarDrawnWithItsPoints) {
  const rig_study::RigFolder folder;
  const LoadedStudy study = folder.Loaded();
  const VehicleObjective objective = study.MakeObjective();
  // Camber and toe of two wheels in seven positions; toe and y of two wheels under one force, alike and opposed.
  ASSERT_EQ(objective.residual_count(), 2 * 2 * 7 + 2 * 2 * 2);
  const Evaluation at_truth = objective.Evaluate(Eigen::Vector3d(kBall_m, kTie_m, kBush_Npm));
  ASSERT_TRUE(at_truth.ok()) << at_truth.detail;
  EXPECT_LT(at_truth.residuals.lpNorm<Eigen::Infinity>(), kZero);
  // The file's points are some 2 mm off, of which a rig sees a tenth of a degree.
  EXPECT_GT(objective.Evaluate(objective.FileValues()).residuals.norm(), 10);
}

TEST(KinematicResiduals, OfRatiosAndTheAxleAreZeroAtTheTruth) {
  const rig_study::RigFolder folder;
  const LoadedStudy study = folder.Loaded(R"(vehicle: car.urdf
kinematics:
  - {file: wheels.csv, noise: {track: 0.2 mm, load: 10 N, steer: 0.01 deg, foot_y: 0.1 mm, centre_x: 0.1 mm}}
  - {file: ratios.csv, motion: left, noise: {motion_ratio: 0.001, length: 0.1 mm}}
  - {file: wheels.csv, name: centre, motion: heave, noise: {roll_centre: 1 mm}}
free: all
)");
  const VehicleObjective objective = study.MakeObjective();
  const Evaluation at_truth = objective.Evaluate(Eigen::Vector3d(kBall_m, kTie_m, kBush_Npm));
  ASSERT_TRUE(at_truth.ok()) << at_truth.detail;
  // Loads are stiffnesses of some 1e7 N/m times 1e-11 m, over 10 N.
  EXPECT_LT(at_truth.residuals.lpNorm<Eigen::Infinity>(), 1e-4);
  // Heave, roll and each wheel alone.
  EXPECT_EQ(at_truth.residuals.size(), 4 * 7 * (1 + 4 * 2) + 7 * 4 + 7);
}

TEST(KinematicResiduals, FollowAStrutWhereAnotherIsAdded) {
  using axle_cars::Vec;
  const std::string stop =
      axle_cars::Frame("top_stop_left", "body", Vec(0, 0.42, 0.6)) +
      axle_cars::Frame("foot_stop_left", "lower_left", Vec(0, 0.42, 0.2) - axle_cars::kLower.front) +
      R"(<fp:stop name="stop_left" parent="top_stop_left" child="foot_stop_left">
<bump gap="0.1 m" stiffness="200 N/mm"/></fp:stop>
<fp:parameter name="k" value="2 kN/mm" lower="1 kN/mm" upper="3 kN/mm" precision="1 N/mm" source="test"/>)";
  const rig_study::RigFolder folder;
  folder.Write("car.urdf", axle_cars::WishboneOnRubber({.rate = "$k", .tags = stop}));
  folder.Write("table.csv", "travel [mm],motion_ratio_coil_left,motion_ratio_stop_left\n-20,1,1\n20,1,1\n");
  LoadedStudy study = folder.Loaded(R"(vehicle: car.urdf
kinematics: [{file: table.csv, motion: heave, noise: {motion_ratio: 0.01}}]
)");
  // Dampers stand before stops in StrutsOf().
  const Vehicle more = rig_study::VehicleOf(axle_cars::WishboneOnRubber(
      {.rate = "$k", .tags = stop + R"(<fp:damper name="damper_left" parent="top_coil_left" child="foot_coil_left">
<linear rate="2 kN*s/m"/></fp:damper>)"}));
  const std::vector<KinematicSweep>& sweeps = rig_study::RigOf(study).fitted;
  const KinematicAnswer as_loaded = KinematicModel(study.vehicle, sweeps).At({2e6});
  const KinematicAnswer extended = KinematicModel(more, sweeps).At({2e6});
  ASSERT_FALSE(as_loaded.refusal || extended.refusal);
  for (const std::size_t curve : {0, 1})
    EXPECT_NEAR((extended.sweeps[0][curve] - as_loaded.sweeps[0][curve]).norm(), 0, kZero);
  // The damper has the coil's ratio, so another strut would show.
  EXPECT_GT((as_loaded.sweeps[0][0] - as_loaded.sweeps[0][1]).norm(), 0.1);
}

TEST(KinematicResiduals, OfAFreeOffsetAreThoseAboutTheMeanWithoutIt) {
  KinematicCurve curve{.quantity = FindKinematicQuantity("camber"),
                       .of_name = "left",
                       .places = {0, 1, 2, 3},
                       .measured = {0.01, 0.03, 0.02, 0.07},
                       .sd = 0.01,
                       .has_free_offset = true};
  const Eigen::Vector4d modelled(0, 0.01, 0.03, 0.02);
  const Eigen::VectorXd contrasts = CurveResiduals(curve, modelled);
  ASSERT_EQ(contrasts.size(), 3);
  curve.has_free_offset = false;
  const Eigen::ArrayXd plain = CurveResiduals(curve, modelled).array();
  EXPECT_NEAR(contrasts.squaredNorm(), (plain - plain.mean()).square().sum(), 1e-12);
  curve.has_free_offset = true;
  for (double& value : curve.measured) value += 0.5;
  EXPECT_NEAR((CurveResiduals(curve, modelled) - contrasts).norm(), 0, 1e-12);
}

/// Adds normal noise of its sd to each point.
void AddNoise(std::vector<KinematicSweep>& sweeps, std::uint64_t seed) {
  RandomStream noise(seed, "rig noise");
  for (KinematicSweep& sweep : sweeps)
    for (KinematicCurve& curve : sweep.curves)
      for (double& value : curve.measured) value += curve.sd * noise.Normal();
}

TEST(KinematicResiduals, IntervalsHoldTheTruth) {
  const rig_study::RigFolder folder;
  const double truth[] = {kBall_m, kTie_m, kBush_Npm};
  constexpr int kSeeds = 10;
  int held = 0;
  double squares = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    LoadedStudy study = folder.Loaded();
    AddNoise(rig_study::RigOf(study).fitted, static_cast<std::uint64_t>(seed));
    const VehicleObjective objective = study.MakeObjective();
    const FitResult fit = Fit(objective, {.from = objective.FileValues()});
    ASSERT_EQ(fit.end, FitEnd::kConverged) << fit.message;
    for (std::size_t i = 0; i < 3; ++i) {
      const FittedParameter& one = fit.parameters[i];
      EXPECT_EQ(one.state, ParameterState::kDetermined) << one.name;
      held += one.lower_95 <= truth[i] && truth[i] <= one.upper_95 ? 1 : 0;
      squares += std::pow((one.value - truth[i]) / one.noise_sd, 2);
    }
  }
  // 30 intervals of 95 %: fewer than 25 hold the truth once in 300 such tests.
  EXPECT_GE(held, 25);
  // Chi-squared of 30 degrees of freedom: 99.8 % lie between these.
  EXPECT_GT(squares, 11.6);
  EXPECT_LT(squares, 59.7);
}

}  // namespace
}  // namespace fourpost::kinematic_residuals_test
