#include "identify/uncertainty/derivative_noise.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/fit/fit.h"
#include "tests/identify/toy_objective.h"

namespace fourpost::derivative_noise_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Eigen::Index kCount = 200;
/// Steps of differences are its cube root, 1e-3.
constexpr double kAccuracy = 1e-9;

/// A jump of twice this size wherever p0 passes a multiple of `period`, elsewhere for each residual.
struct Planted {
  double size = 0;
  double period = 1e-6;

  double At(double p, Eigen::Index i) const {
    return size == 0 ? 0 : size * Sawtooth(p / period + 0.618 * static_cast<double>(i));
  }
};

double Place(Eigen::Index i) { return static_cast<double>(i) / static_cast<double>(kCount - 1); }

/// p0 + p1 x + p2 x^2 against those of 1, with noise of 1 of a deviation of 0.01; p0 with jumps. p1 and p2 are strongly
/// correlated.
VehicleObjective Curve(const Planted& planted) {
  return ToyObjective(3, kCount, kAccuracy, [planted](const std::vector<double>& p) {
    Eigen::VectorXd residuals(kCount);
    for (Eigen::Index i = 0; i < kCount; ++i) {
      const double x = Place(i);
      const double noise = std::sin(12.9898 * static_cast<double>(i * i + 1)) * std::sqrt(2.0);
      residuals[i] = ((p[0] - 1) + (p[1] - 1) * x + (p[2] - 1) * x * x) / 0.01 + noise + planted.At(p[0], i);
    }
    return residuals;
  });
}

FitOptions Options() {
  FitOptions options;
  options.search = ThesisDvhde();
  options.stop.max_evaluations = 60;
  options.starts = 1;
  options.identify_first = true;
  return options;
}

TEST(DerivativeNoise, SmoothCurvesHaveDeviations) {
  const VehicleObjective objective = Curve({});
  const FitResult fit = Fit(objective, Options());
  for (const FittedParameter& parameter : fit.parameters)
    EXPECT_EQ(parameter.state, ParameterState::kDetermined) << parameter.name;
}

// Whatever the size of jumps and how close they are: no wrong number without a word. Refinement does not get far among
// large ones, so derivatives are looked at where it began.
TEST(DerivativeNoise, EitherTheDeviationIsRightOrItIsCalledNoise) {
  const VehicleObjective smooth = Curve({});
  const FitResult right = Fit(smooth, Options());
  int noisy = 0;
  int sound = 0;
  for (const double period : {1e-9, 3e-7, 1e-5, 2e-4})
    for (const double size : {1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0, 10.0, 1e3}) {
      const VehicleObjective objective = Curve({size, period});
      const FitResult fit = Fit(objective, Options());
      ASSERT_NE(fit.end, FitEnd::kUnidentified) << size << ' ' << period;
      // Others may lose their deviation with it, but not for being undetermined: at most it becomes as large as they.
      for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        const FittedParameter& parameter = fit.parameters[i];
        const bool is_open = parameter.state == ParameterState::kUndetermined;
        EXPECT_FALSE(is_open && !(parameter.sd > parameter.value && std::isfinite(parameter.sd)))
            << parameter.name << ' ' << size << ' ' << period;
        if (i != 0) {
          EXPECT_NE(parameter.state, ParameterState::kNoise) << parameter.name << ' ' << size << ' ' << period;
        }
      }
      const FittedParameter& jumping = fit.parameters[0];
      (jumping.state == ParameterState::kNoise ? noisy : sound) += 1;
      if (jumping.state != ParameterState::kDetermined) {
        EXPECT_TRUE(std::isnan(jumping.sd) && std::isnan(jumping.lower_95) && std::isnan(jumping.upper_95));
        continue;
      }
      // What NoisyColumns() lets pass.
      const double uninflated = jumping.sd / fit.covariance->inflation;
      EXPECT_NEAR(uninflated / (right.parameters[0].sd / right.covariance->inflation), 1, 0.2) << size << ' ' << period;
    }
  EXPECT_GE(noisy, 8);
  EXPECT_GE(sound, 8);
}

/// p0 with jumps, p1 sound, p2 without any effect.
VehicleObjective WithIdle(const Planted& planted) {
  return ToyObjective(3, kCount, kAccuracy, [planted](const std::vector<double>& p) {
    Eigen::VectorXd residuals(kCount);
    for (Eigen::Index i = 0; i < kCount; ++i)
      residuals[i] = (p[0] - 1.1) + (p[1] - 0.9) * Place(i) / 0.01 + planted.At(p[0], i);
    return residuals;
  });
}

TEST(DerivativeNoise, WhatChangesNothingIsStillRefused) {
  for (const double size : {0.0, 1e-3, 1.0, 1e3}) {
    const VehicleObjective objective = WithIdle({size});
    const FitResult fit = Fit(objective, Options());
    ASSERT_EQ(fit.end, FitEnd::kUnidentified) << size;
    EXPECT_THAT(fit.before->weakest, ElementsAre("p2 +1 %")) << size;
  }
}

TEST(DerivativeNoise, NoiseIsNeverUndetermined) {
  // So loud that nothing else seems to have an effect; steps are no multiples of the period.
  const VehicleObjective objective = Curve({1e4, 3.7e-7});
  Archive archive(objective.MakeProblem());
  const Identifiability before = IdentifiabilityBefore(archive, objective, 1).value();
  EXPECT_FALSE(before.HasUndetermined());
  EXPECT_THAT(before.noisy, ElementsAre("p0"));
  EXPECT_EQ(before.covariance.rank, 2);
  // p1 and p2.
  EXPECT_EQ(before.covariance.directions.cols(), 2);
}

TEST(DerivativeNoise, AskedOfTheModelWhereItKnows) {
  const VehicleObjective objective = Curve({1e3});
  Problem problem = objective.MakeProblem();
  int asked = 0;
  problem.differentiate = [&](const Eigen::VectorXd&) {
    ++asked;
    Eigen::MatrixXd jacobian(kCount, 3);
    for (Eigen::Index i = 0; i < kCount; ++i)
      jacobian.row(i) = Eigen::RowVector3d(1, Place(i), Place(i) * Place(i)) / 0.01;
    return jacobian;
  };
  Archive archive(problem);
  const FitVariables variables(archive.lattice());
  const Eigen::VectorXd x = variables.FromValues(objective.FileValues());
  const Eigen::VectorXd here = archive.EvaluateValues({objective.FileValues()}).front().residuals;
  const Eigen::MatrixXd differences = DifferenceJacobian(archive, variables, x, here, 1e-3).value();
  const Eigen::MatrixXd own = JacobianAgain(archive, variables, x, here, 1e-3).value();
  EXPECT_EQ(asked, 1);
  EXPECT_THAT(NoisyColumns(differences, own), ElementsAre(0));
  EXPECT_THAT(NoisyColumns(own, own), IsEmpty());
}

TEST(DerivativeNoise, DisagreementIsAShareOfTheLargerColumn) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2, 3);
  Eigen::MatrixXd b = a;
  a.col(0) << 3, 4;
  b.col(0) << 0, 10;
  a.col(1) << 1, 0;
  b.col(1) << 1, 0;
  EXPECT_THAT(Disagreement(a, b), ElementsAre(testing::DoubleEq(std::sqrt(45.0) / 10), 0, 0));
}

// Two columns alike but for a hundredth: noise of a hundredth hides in neither and determines both.
TEST(DerivativeNoise, FindsNoiseThatIsSmallBesideTheColumn) {
  Eigen::MatrixXd exact(kCount, 2);
  Eigen::MatrixXd jacobian(kCount, 2);
  Eigen::MatrixXd again(kCount, 2);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    exact.row(i) << 1, 1 + 0.01 * std::cos(30 * Place(i));
    const double noise = 0.02 * Sawtooth(0.618 * static_cast<double>(i));
    jacobian.row(i) = exact.row(i) + Eigen::RowVector2d(noise, 0);
    again.row(i) = exact.row(i) + Eigen::RowVector2d(3 * noise, 0);
  }
  EXPECT_LT(Disagreement(jacobian, again)[0], 0.05);
  EXPECT_THAT(NoisyColumns(jacobian, again), ElementsAre(0));
  EXPECT_THAT(NoisyColumns(exact, exact), IsEmpty());
}

}  // namespace
}  // namespace fourpost::derivative_noise_test
