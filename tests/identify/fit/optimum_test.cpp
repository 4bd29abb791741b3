#include "identify/fit/optimum.h"

#include <cmath>

#include <gtest/gtest.h>

#include "identify/fit/fit.h"
#include "tests/identify/toy_objective.h"

namespace fourpost::optimum_test {
namespace {

constexpr Eigen::Index kCount = 200;

Eigen::VectorXd Wave(double cycles) {
  Eigen::VectorXd wave(kCount);
  for (Eigen::Index k = 0; k < kCount; ++k) wave[k] = std::sin(cycles * 0.031415926535897934 * static_cast<double>(k));
  return wave;
}

/// 100 (ln p - `truth`) times one wave; the instrument adds `taken_up` times that wave, and another one, to what is
/// read. The data have 3 of its standard deviations, and noise of 1.
FitResult FitOf(double taken_up, double of_its_own, double truth = 0) {
  const VehicleObjective toy = ToyObjective(1, kCount, 1e-15, {});
  const Eigen::VectorXd change = taken_up * Wave(1) + of_its_own * Wave(3);
  ResidualBlock block{.name = "toy", .count = kCount, .accuracy = 1e-15};
  block.evaluate = [=](const std::vector<double>& values, const Deadline&) {
    Eigen::VectorXd residuals = 100 * (std::log(values[0]) - truth) * Wave(1) - 3 * change;
    for (Eigen::Index k = 0; k < kCount; ++k) residuals[k] += k % 2 == 0 ? 1 : -1;
    return Evaluation{.residuals = residuals};
  };
  block.by_calibrations = [=](const std::vector<double>&) { return Eigen::MatrixXd(change); };
  FitOptions options;
  options.stop.max_evaluations = 10;
  options.starts = 0;
  options.threads = 1;
  return Fit(VehicleObjective(toy.vehicle(), toy.free(), {block}, {{.of = "load_cells", .sd = 0.01}}), options);
}

// Closed form: of its own the instrument has the squares s = 2^2 N / 2, and residuals seem to have those of noise, 1,
// and of 3 instruments, 9 s / N, each; then the mean is 3 s / (s + 1 + 9 s / N), and p follows by a tenth of it.
TEST(Optimum, EstimatesCalibrationsByWhatIsTheirOwn) {
  const FitResult fit = FitOf(10, 2);
  constexpr double kSquares = 2.0 * kCount;
  constexpr double kMean = 3 * kSquares / (kSquares + 1 + 9 * kSquares / kCount);
  ASSERT_EQ(fit.certainty->calibrations.size(), 1u);
  EXPECT_NEAR(fit.certainty->calibrations[0].estimate, 0.01 * kMean, 1e-4 * 0.01);
  EXPECT_NEAR(std::log(fit.parameters[0].value), 0.3 - 0.1 * kMean, 1e-4);
  EXPECT_FALSE(fit.are_calibrations_unused);
}

// The parameter takes up all but half a per cent: less than derivatives are good for.
TEST(Optimum, LeavesACalibrationThatTheParametersTakeUpAsStated) {
  const FitResult fit = FitOf(10, 0.05);
  EXPECT_EQ(fit.certainty->calibrations[0].estimate, 0);
  EXPECT_NEAR(fit.certainty->calibrations[0].estimate_sd, 0.01, 1e-9);
  EXPECT_NEAR(std::log(fit.parameters[0].value), 0.3, 1e-3);
  EXPECT_NEAR(fit.certainty->held_sd[0], 0.1, 1e-6);
  EXPECT_FALSE(fit.are_calibrations_unused);
}

// The step leads to exp(-2.1), and the parameter ends at its bound 0.2 = exp(-1.6), short of what it was to cancel.
TEST(Optimum, TakesCalibrationsAsStatedWhereTheStepDoesNotHold) {
  const FitResult fit = FitOf(50, 2, -2.2);
  EXPECT_TRUE(fit.are_calibrations_unused);
  EXPECT_EQ(fit.certainty->calibrations[0].estimate, 0);
  EXPECT_NEAR(fit.certainty->calibrations[0].estimate_sd, 0.01, 1e-9);
}

}  // namespace
}  // namespace fourpost::optimum_test
