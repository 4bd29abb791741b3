#include "identify/problems/test_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/problems/coil_spring.h"
#include "identify/problems/gear_train.h"
#include "identify/problems/half_car_twin.h"
#include "identify/problems/oscillator.h"
#include "identify/problems/pressure_vessel.h"
#include "identify/problems/speed_reducer.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/refine/refine.h"

namespace fourpost::test_problem_test {
namespace {

using Teeth = std::vector<int>;

TEST(GearTrain, HasFourBestOfAllDesigns) {
  std::set<Teeth> best;
  double least = 1, next = 1;
  std::int64_t designs = 0;
  for (int a = 12; a <= 60; ++a)
    for (int b = 12; b <= 60; ++b)
      for (int c = 12; c <= 60; ++c)
        for (int d = 12; d <= 60; ++d) {
          ++designs;
          const double cost = std::pow(1 / 6.931 - static_cast<double>(a * b) / static_cast<double>(c * d), 2);
          if (cost <= kGearTrainTarget) best.insert({a, b, c, d});
          else next = std::min(next, cost);
          least = std::min(least, cost);
        }
  EXPECT_EQ(designs, 5764801);
  EXPECT_THAT(best, testing::ElementsAre(Teeth{16, 19, 43, 49}, Teeth{16, 19, 49, 43}, Teeth{19, 16, 43, 49},
                                         Teeth{19, 16, 49, 43}));
  // Printed digits.
  EXPECT_NEAR(least, 2.7008571e-12, 0.5e-19);
  EXPECT_NEAR(next, 2.3078e-11, 0.5e-15);
  EXPECT_EQ(GearTrainProblem().evaluate(Eigen::Vector4d(19, 16, 43, 49)).cost(), least);
}

TEST(CoilSpring, IsBestWhereItsDeflectionIsLeast) {
  const Problem problem = CoilSpringProblem(1e-10);
  // 700 / rate = 1.25 with 9 coils of 0.283.
  const double diameter = std::cbrt(1.25 * 11.5e6 * std::pow(0.283, 4) / (8 * 9 * 700));
  EXPECT_NEAR(diameter, 1.2230410100, 0.5e-10);
  const Evaluation best = problem.evaluate(Eigen::Vector3d(9, 36, diameter + 1e-9));
  ASSERT_TRUE(best.ok()) << best.detail;
  EXPECT_NEAR(best.cost(), 2.6585591660, 1e-8);
  const Evaluation beyond = problem.evaluate(Eigen::Vector3d(9, 36, diameter - 1e-4));
  EXPECT_EQ(beyond.failure, Failure::kInfeasible);
  EXPECT_GT(beyond.violation, 0);
  EXPECT_GT(problem.evaluate(Eigen::Vector3d(9, 36, diameter - 1e-3)).violation, beyond.violation);
}

// The least diameter that coils and wire allow costs least; the next best wire costs 1.5 % more.
TEST(CoilSpring, HasItsBestPairOfAllPairs) {
  const Problem problem = CoilSpringProblem(1e-3);
  const auto least_cost = [&](int coils, int wire) {
    for (int i = 0; i <= 2400; ++i) {
      const Evaluation evaluation = problem.evaluate(Eigen::Vector3d(coils, wire, 0.6 + 1e-3 * i));
      if (evaluation.ok()) return evaluation.cost();
    }
    return 100.0;
  };
  std::vector<std::pair<double, std::pair<int, int>>> pairs;
  for (int coils = 1; coils <= 70; ++coils)
    for (int wire = 1; wire <= 42; ++wire)
      if (const double cost = least_cost(coils, wire); cost < 100) pairs.push_back({cost, {coils, wire}});
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs[0].second, std::make_pair(9, 36));
  EXPECT_EQ(pairs[1].second, std::make_pair(5, 37));
  EXPECT_NEAR(pairs[1].first / pairs[0].first, 1.015, 1e-3);
}

// Least radius and length of each pair of thicknesses: the radius at the bound of the shell or of the head, or the
// length at its own; the cost rises with both.
TEST(PressureVessel, HasItsBestPairOfAllPairs) {
  const Problem problem = PressureVesselProblem();
  const auto least_cost = [&](int shell, int head) {
    double least = 1e9;
    const double most = std::min({200.0, 0.0625 * shell / 0.0193, 0.0625 * head / 0.00954});
    for (int i = 0; i <= 4000; ++i) {
      const double radius = 10 + (most - 10) * i / 4000;
      const double length = std::max(10.0, 1296000 / (std::numbers::pi * radius * radius) - 4 * radius / 3);
      if (most < 10 || length > 200) continue;
      const Evaluation evaluation =
          problem.evaluate(Eigen::Vector4d(shell, head, radius * (1 - 1e-12), length * (1 + 1e-11)));
      if (evaluation.ok()) least = std::min(least, evaluation.cost());
    }
    return least;
  };
  std::vector<std::pair<double, std::pair<int, int>>> pairs;
  for (int shell = 1; shell <= 40; ++shell)
    for (int head = 1; head <= 30; ++head) pairs.push_back({least_cost(shell, head), {shell, head}});
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs[0].second, std::make_pair(13, 7));
  EXPECT_NEAR(pairs[0].first, 6059.714335, 1e-5);  // printed digits
  EXPECT_NEAR(pairs[1].first / pairs[0].first, 1.005, 1e-3);
}

TEST(SpeedReducer, HasThePublishedWeight) {
  Eigen::VectorXd best(7);
  // Published digits, the second length and both diameters a millionth larger: constraints hold them.
  best << 3.5, 0.7, 17, 7.3, 7.715321, 3.350216, 5.286655;
  const Evaluation evaluation = SpeedReducerProblem().evaluate(best);
  ASSERT_TRUE(evaluation.ok()) << evaluation.detail;
  EXPECT_NEAR(evaluation.cost(), 2994.471, 2e-3);
  for (const int j : {0, 5, 6}) {
    Eigen::VectorXd less = best;
    less[j] -= 1e-5;
    EXPECT_FALSE(SpeedReducerProblem().evaluate(less).ok()) << j;
  }
}

TEST(Oscillator, CostsNothingAtItsTruthAndOnlyThere) {
  const Problem problem = OscillatorProblem();
  EXPECT_EQ(problem.lattice.count(0), 50001);
  EXPECT_EQ(problem.lattice.count(1), 100001);
  EXPECT_EQ(problem.lattice.count(2), 50001);
  EXPECT_EQ(problem.evaluate(Eigen::Vector3d(200, 15000, 1500)).cost(), 0);
  // The motion alone would not tell these from the truth.
  EXPECT_GT(problem.evaluate(Eigen::Vector3d(220, 16500, 1650)).cost(), 0.1);
}

// Ground of straight lines between samples.
double GroundAt(int sample) {
  const double t = sample * 0.01;
  return 0.02 * std::sin(2 * std::numbers::pi * (0.5 * t + 4.5 * t * t / 10));
}

// z at the samples, by a hundred Runge-Kutta steps between two of them.
Eigen::VectorXd MarchOscillator(double m, double k, double d) {
  Eigen::VectorXd z(501);
  Eigen::Vector2d x(0, 0);
  for (int i = 0; i <= 500; ++i) {
    z[i] = x[0];
    const double slope = (GroundAt(i + 1) - GroundAt(i)) / 0.01;
    const auto rate = [&](const Eigen::Vector2d& s, double t) {
      return Eigen::Vector2d(s[1], (-k * (s[0] - GroundAt(i) - slope * t) - d * (s[1] - slope)) / m);
    };
    const double h = 1e-4;
    for (int j = 0; j < 100; ++j) {
      const double t = j * h;
      const Eigen::Vector2d a = rate(x, t);
      const Eigen::Vector2d b = rate(x + h / 2 * a, t + h / 2);
      const Eigen::Vector2d c = rate(x + h / 2 * b, t + h / 2);
      x += h / 6 * (a + 2 * b + 2 * c + rate(x + h * c, t + h));
    }
  }
  return z;
}

TEST(Oscillator, MovesAsTheEquationOfMotionTells) {
  const Eigen::VectorXd residuals = OscillatorProblem().evaluate(Eigen::Vector3d(150, 12000, 900)).residuals;
  const Eigen::VectorXd truth = MarchOscillator(200, 15000, 1500);
  const double sd = std::sqrt((truth.array() - truth.mean()).square().mean());
  const Eigen::VectorXd expected = std::sqrt(100.0 / 501) / sd * (MarchOscillator(150, 12000, 900) - truth);
  // Runge-Kutta's error, of fourth order in steps of 1/700 of the period.
  EXPECT_LT((residuals.head(501) - expected).cwiseAbs().maxCoeff(), 1e-8 * expected.cwiseAbs().maxCoeff());
}

class HalfCarTwin : public testing::TestWithParam<std::string_view> {};

// Noise of 1 % makes a cost of about the number of residuals, within four deviations of a chi-square.
TEST_P(HalfCarTwin, CostsItsNoiseAtTheTruth) {
  const TestProblem twin = MakeTestProblem(GetParam());
  const Evaluation truth = twin.problem.evaluate(HalfCarTruth());
  ASSERT_TRUE(truth.ok());
  const auto n = static_cast<double>(truth.residuals.size());
  EXPECT_NEAR(truth.cost(), n, 4 * std::sqrt(2 * n));
  EXPECT_DOUBLE_EQ(twin.target_cost, 1.02 * truth.cost());
  EXPECT_EQ(twin.problem.residual_count, truth.residuals.size());
}

TEST_P(HalfCarTwin, FeelsEveryParameterAndTheirCommonScale) {
  const TestProblem twin = MakeTestProblem(GetParam());
  for (Eigen::Index j = 0; j < 12; ++j) {
    Eigen::VectorXd values = HalfCarTruth();
    values[j] *= 1.1;
    EXPECT_GT(twin.problem.evaluate(values).cost(), twin.target_cost) << j;
  }
  // Forces tell what accelerations alone cannot.
  EXPECT_GT(twin.problem.evaluate(1.1 * HalfCarTruth()).cost(), 10 * twin.target_cost);
}

INSTANTIATE_TEST_SUITE_P(TestProblems, HalfCarTwin, testing::Values("half_car", "half_car_frequency"));

class DifferentiatedProblem : public testing::TestWithParam<std::string_view> {};

// Away from the truth, where residuals are large.
TEST_P(DifferentiatedProblem, TellsTheDerivativesThatDifferencesShow) {
  const Problem problem = MakeTestProblem(GetParam()).problem;
  Archive archive(problem);
  const FitVariables variables(problem.lattice);
  const Eigen::VectorXd x = 0.45 * variables.lower() + 0.55 * variables.upper();
  const Eigen::VectorXd residuals = problem.evaluate(variables.ToValues(x)).residuals;
  const auto by = [&](Differences differences) {
    return DifferenceJacobian(archive, variables, x, residuals, 1e-5, differences).value();
  };
  const Eigen::MatrixXd automatic = by(Differences::kAutomatic);
  EXPECT_EQ(archive.counts().paid, x.size());
  const Eigen::MatrixXd central = by(Differences::kCentral);
  // Steps of h = 1e-5 in the logarithm err by h^2 / 6 of the third derivative, rounding by 1e-16 / h; where a damper's
  // rate passes zero at another instant, by h of a kink.
  for (Eigen::Index j = 0; j < x.size(); ++j)
    EXPECT_LT((automatic.col(j) - central.col(j)).norm(), 1e-6 * automatic.col(j).norm()) << j;
}

TEST_P(DifferentiatedProblem, IsRefinedToTheSameByEither) {
  const Problem problem = MakeTestProblem(GetParam()).problem;
  const auto refined = [&](Differences differences) {
    Archive archive(problem);
    const FitVariables variables(problem.lattice);
    return Refine(archive, variables.ToValues(0.45 * variables.lower() + 0.55 * variables.upper()),
                  {.differences = differences});
  };
  const RefineResult automatic = refined(Differences::kAutomatic);
  const RefineResult central = refined(Differences::kCentral);
  EXPECT_EQ(automatic.end, RefineEnd::kConverged);
  // Step and cost tolerances of 1e-8.
  EXPECT_LT((automatic.values - central.values).cwiseQuotient(central.values).cwiseAbs().maxCoeff(), 1e-5);
  // One evaluation per parameter in place of two.
  EXPECT_LT(automatic.evaluations, 0.7 * static_cast<double>(central.evaluations));
}

INSTANTIATE_TEST_SUITE_P(TestProblems, DifferentiatedProblem, testing::Values("oscillator", "half_car"));

// The model does not tell any.
TEST(HalfCarTwinInFrequency, IsDifferentiatedByDifferences) {
  const Problem problem = MakeTestProblem("half_car_frequency").problem;
  EXPECT_FALSE(problem.differentiate);
  Archive archive(problem);
  const FitVariables variables(problem.lattice);
  const Eigen::VectorXd x = variables.FromValues(HalfCarTruth());
  const Eigen::VectorXd residuals = problem.evaluate(HalfCarTruth()).residuals;
  const auto by = [&](Differences differences) {
    return DifferenceJacobian(archive, variables, x, residuals, 1e-5, differences).value();
  };
  EXPECT_EQ(by(Differences::kAutomatic), by(Differences::kCentral));
}

TEST(TestProblems, AreAllThereByName) {
  for (const std::string_view name : kTestProblems) EXPECT_NO_THROW(MakeTestProblem(name)) << name;
  EXPECT_THROW(MakeTestProblem("gear"), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::test_problem_test
