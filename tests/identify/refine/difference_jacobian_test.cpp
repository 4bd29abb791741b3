#include "identify/refine/difference_jacobian.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fourpost::difference_jacobian_test {
namespace {

constexpr double kStep = 1e-4;
constexpr double kEpsilon = 2.220446049250313e-16;
// Differences of numbers of size 1 carry their rounding, a few epsilon, over the step.
constexpr double kRounding = 10 * kEpsilon / kStep;

// a exp(-k t) at t = 0, 0.1, ... 1.9; its third derivative by (ln a, ln k) is below 2 |r| for k t <= 1.
Evaluation Decay(const Eigen::VectorXd& p) {
  Evaluation evaluation;
  evaluation.residuals.resize(20);
  for (int i = 0; i < 20; ++i) evaluation.residuals[i] = p[0] * std::exp(-p[1] * 0.1 * i);
  return evaluation;
}

// d / d ln a = r, d / d ln k = -k t r.
Eigen::MatrixXd DecayJacobian(const Eigen::VectorXd& p) {
  Eigen::MatrixXd jacobian(20, 2);
  jacobian.col(0) = Decay(p).residuals;
  for (int i = 0; i < 20; ++i) jacobian(i, 1) = -p[1] * 0.1 * i * jacobian(i, 0);
  return jacobian;
}

class DifferenceJacobianOfDecay : public testing::Test {
 protected:
  std::optional<Eigen::MatrixXd> At(double a, double k, int threads = 1) {
    Archive archive({lattice_, evaluate_}, threads);
    const FitVariables variables(lattice_);
    const Eigen::Vector2d values(a, k);
    auto jacobian =
        DifferenceJacobian(archive, variables, variables.FromValues(values), Decay(values).residuals, kStep);
    paid_ = archive.counts().paid;
    return jacobian;
  }

  double ErrorAt(double a, double k) {
    return (At(a, k).value() - DecayJacobian(Eigen::Vector2d(a, k))).cwiseAbs().maxCoeff();
  }

  const Lattice lattice_{{{"a", 0.1, 1, 0.01}, {"k", 0.1, 0.5, 0.01}}};
  std::function<Evaluation(const Eigen::VectorXd&)> evaluate_ = Decay;
  std::int64_t paid_ = 0;
};

TEST_F(DifferenceJacobianOfDecay, IsTheDerivative) {
  // Central differences: step^2 / 6 of the third derivative.
  EXPECT_LT(ErrorAt(0.6, 0.3), 2 * kStep * kStep / 6 + kRounding);
  EXPECT_EQ(paid_, 4);
}

TEST_F(DifferenceJacobianOfDecay, IsOfSecondOrderAtTheBoundsToo) {
  // Differences to one side: step^2 / 3 of the third derivative.
  EXPECT_LT(ErrorAt(0.1, 0.1), 2 * kStep * kStep / 3 + kRounding);
  EXPECT_LT(ErrorAt(1, 0.5), 2 * kStep * kStep / 3 + kRounding);
  EXPECT_EQ(paid_, 4);
}

TEST_F(DifferenceJacobianOfDecay, EvaluatesInsideTheBoundsOnly) {
  evaluate_ = [this](const Eigen::VectorXd& p) {
    for (Eigen::Index j = 0; j < 2; ++j) {
      EXPECT_GE(p[j], lattice_.axes()[static_cast<std::size_t>(j)].lower);
      EXPECT_LE(p[j], lattice_.axes()[static_cast<std::size_t>(j)].upper);
    }
    return Decay(p);
  };
  At(0.1, 0.5);
  At(1, 0.1);
  At(0.1 * (1 + 0.5 * kStep), 0.5 * (1 - 0.5 * kStep));
}

TEST_F(DifferenceJacobianOfDecay, TakesTheOtherSideWhereOneFails) {
  const double k = 0.3;
  for (const double sign : {1.0, -1.0}) {
    evaluate_ = [=](const Eigen::VectorXd& p) {
      return sign * (p[1] - k) > 1e-12 ? Failed(Failure::kNotConverged, "") : Decay(p);
    };
    // One difference: step / 2 of the second derivative, which is below 1 here.
    EXPECT_LT(ErrorAt(0.6, k), kStep / 2);
  }
}

TEST_F(DifferenceJacobianOfDecay, TakesTheFurtherPointWhereTheNearerFailsAtABound) {
  evaluate_ = [](const Eigen::VectorXd& p) {
    const double steps = std::log(p[1] / 0.1) / kStep;
    return steps > 0.5 && steps < 1.5 ? Failed(Failure::kNotConverged, "") : Decay(p);
  };
  // One difference over two steps: step of the second derivative.
  EXPECT_LT(ErrorAt(0.6, 0.1), kStep);
}

TEST_F(DifferenceJacobianOfDecay, IsNothingWhereBothSidesFail) {
  evaluate_ = [](const Eigen::VectorXd& p) { return p[1] != 0.3 ? Failed(Failure::kNotConverged, "") : Decay(p); };
  EXPECT_FALSE(At(0.6, 0.3));
}

TEST_F(DifferenceJacobianOfDecay, IsTheSameForAnyNumberOfThreads) {
  const auto alone = At(0.6, 0.3, 1);
  EXPECT_EQ(alone, At(0.6, 0.3, 2));
  EXPECT_EQ(alone, At(0.6, 0.3, 4));
}

TEST(DifferenceJacobian, OfAParabolaIsExactAtABound) {
  const Lattice lattice({{"x", 0, 1, 0.1}});
  Archive archive({lattice, [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::VectorXd::Constant(1, 1 + 3 * p[0] + 5 * p[0] * p[0]);
                     return evaluation;
                   }});
  const FitVariables variables(lattice);
  const auto slope = [&](double x, double r) {
    const auto one = [](double v) { return Eigen::VectorXd::Constant(1, v); };
    return (*DifferenceJacobian(archive, variables, one(x), one(r), kStep))(0, 0);
  };
  EXPECT_NEAR(slope(0, 1), 3, kRounding);
  EXPECT_NEAR(slope(1, 9), 13, 10 * kRounding);
}

TEST(DifferenceJacobian, FitsItsStepIntoANarrowRange) {
  // ln(1.00002) is a fifth of the step.
  const Lattice lattice({{"x", 1, 1.00002, 0.00001}});
  Archive identity({lattice, [](const Eigen::VectorXd& p) {
                      Evaluation evaluation;
                      evaluation.residuals = p;
                      return evaluation;
                    }});
  const FitVariables variables(lattice);
  const Eigen::VectorXd values = Eigen::VectorXd::Constant(1, 1.00001);
  const auto jacobian = DifferenceJacobian(identity, variables, variables.FromValues(values), values, kStep);
  // dp / d ln p = p, to the rounding over a step of a quarter of 2e-5.
  EXPECT_NEAR((*jacobian)(0, 0), 1.00001, 10 * kEpsilon / 5e-6);
}

TEST(DifferenceJacobian, TakesOneEvaluationPerColumnForward) {
  Archive archive({Lattice({{"a", -1, 1, 0.1}, {"b", -1, 1, 0.1}}), [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::Vector2d(3 * p[0], p[0] - 2 * p[1]);
                     return evaluation;
                   }});
  const FitVariables variables(archive.lattice());
  // x = (p + 1) / 2; the second one at its upper bound.
  const Eigen::Vector2d x(0.3, 1);
  const Eigen::VectorXd here = archive.EvaluateValues({variables.ToValues(x)}).front().residuals;
  const std::int64_t before = archive.counts().paid;
  const auto jacobian = DifferenceJacobian(archive, variables, x, here, 1e-3, Differences::kForward);
  EXPECT_EQ(archive.counts().paid - before, 2);
  Eigen::Matrix2d expected;
  expected << 6, 0, 2, -4;
  // Rounding of residuals over the step.
  EXPECT_LT((*jacobian - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DifferenceJacobian, StepsAWholeIndexOnADiscreteAxis) {
  Archive archive({Lattice({{.name = "teeth", .lower = 0, .upper = 50, .precision = 1, .discrete = true}}),
                   [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::VectorXd::Constant(1, 4 * p[0]);
                     return evaluation;
                   }});
  const FitVariables variables(archive.lattice());
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(1, 0.5);
  const Eigen::VectorXd here = archive.EvaluateValues({variables.ToValues(x)}).front().residuals;
  const auto jacobian = DifferenceJacobian(archive, variables, x, here, 1e-5);
  EXPECT_NEAR((*jacobian)(0, 0), 200, 1e-9);
}

/// Rounded to `accuracy`, as by a solver that goes no further.
Evaluation RoughDecay(const Eigen::VectorXd& p, double accuracy) {
  Evaluation evaluation = Decay(p);
  for (double& r : evaluation.residuals) r *= 1 + accuracy * std::sin(1e9 * (r + p[1]));
  return evaluation;
}

TEST(DifferenceStep, IsTiedToTheAccuracyOfTheSolver) {
  constexpr double kAccuracy = 1e-6;
  const Problem problem{.lattice = Lattice({{"a", 0.1, 1, 0.01}, {"k", 0.1, 0.5, 0.01}}),
                        .evaluate = [](const Eigen::VectorXd& p) { return RoughDecay(p, kAccuracy); },
                        .accuracy = kAccuracy};
  Archive archive(problem);
  const FitVariables variables(problem.lattice);
  const Eigen::Vector2d values(0.5, 0.3);
  const auto error = [&](double step) {
    const auto jacobian = DifferenceJacobian(archive, variables, variables.FromValues(values),
                                             RoughDecay(values, kAccuracy).residuals, step);
    return (jacobian.value() - DecayJacobian(values)).cwiseAbs().maxCoeff();
  };
  const double tied = error(StepFor(kAccuracy, Differences::kCentral));
  // The accuracy over the step, and the step squared times the third derivative over 6.
  EXPECT_LT(tied, 1e-6 / 1e-2 + 2 * 1e-4 / 6);
  EXPECT_GT(error(1e-5), 10 * tied);
  EXPECT_GT(error(0.1), 10 * tied);
  EXPECT_EQ(StepFor(1e-6, Differences::kForward), 1e-3);
}

}  // namespace
}  // namespace fourpost::difference_jacobian_test
