#include "analysis/signals/arx.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"

namespace fourpost::arx_test {
namespace {

using Eigen::Index;

/// y_k = 1.6 y_{k-1} - 0.8 y_{k-2} + u1_k + 0.5 u1_{k-1} - 0.3 u2_{k-1} + 0.1, then noise of the output.
ArxRecord Known(Index samples, double noise, std::uint64_t seed) {
  RandomStream draws(seed, "arx");
  ArxRecord record{.inputs = Eigen::MatrixXd(samples, 2), .output = Eigen::VectorXd::Zero(samples)};
  for (double& value : record.inputs.reshaped()) value = draws.Normal();
  for (Index k = 2; k < samples; ++k)
    record.output[k] = 1.6 * record.output[k - 1] - 0.8 * record.output[k - 2] + record.inputs(k, 0) +
                       0.5 * record.inputs(k - 1, 0) - 0.3 * record.inputs(k - 1, 1) + 0.1;
  for (double& value : record.output) value += noise * draws.Normal();
  return record;
}

void ExpectKnown(const Arx& arx, double tolerance) {
  ASSERT_EQ(arx.order, 2);
  EXPECT_NEAR(arx.own[0], 1.6, tolerance);
  EXPECT_NEAR(arx.own[1], -0.8, tolerance);
  EXPECT_NEAR(arx.of_inputs(0, 0), 1, tolerance);
  EXPECT_NEAR(arx.of_inputs(1, 0), 0.5, tolerance);
  EXPECT_NEAR(arx.of_inputs(1, 1), -0.3, tolerance);
  EXPECT_NEAR(arx.of_inputs(2, 1), 0, tolerance);
  EXPECT_NEAR(arx.constant, 0.1, tolerance);
}

TEST(Arx, FindsOrderAndCoefficientsOfAKnownDifferenceEquation) {
  const ArxRecord record = Known(3000, 0, 1);
  const std::optional<Arx> arx = FitArx({&record, 1}, 8);
  ASSERT_TRUE(arx);
  ExpectKnown(*arx, 1e-9);  // rounding times the condition of the regressors, about 1e3
  const std::vector<Eigen::VectorXd> run = {arx->FreeRun(record)};
  EXPECT_LT(ErrorOf({&record, 1}, run), 1e-12);
}

// Noise of the output biases plain least squares by its share of the signal; free runs are then left with the noise.
TEST(Arx, LeavesTheNoiseOfTheOutputToAFreeRun) {
  const ArxRecord clean = Known(20000, 0, 2);
  const double sd = std::sqrt((clean.output.array() - clean.output.mean()).square().mean());
  const ArxRecord noisy = Known(20000, 0.1 * sd, 2);
  const ArxRecord other = Known(20000, 0.1 * sd, 3);
  const std::optional<Arx> arx = FitArx({&noisy, 1}, 12);
  ASSERT_TRUE(arx);
  const std::vector<Eigen::VectorXd> run = {arx->FreeRun(other)};
  const double floor = 100 * 0.01 / 1.01;
  // Chi-square of 20000 samples scatters by 1 %.
  EXPECT_NEAR(ErrorOf({&other, 1}, run), floor, 0.06 * floor);
  const std::vector<Eigen::VectorXd> step = {arx->OneStep(other)};
  EXPECT_GT(ErrorOf({&other, 1}, step), 0.8 * floor);
}

TEST(Arx, FitsAFreeDecayWithoutInputs) {
  ArxRecord record{.inputs = Eigen::MatrixXd(400, 0), .output = Eigen::VectorXd(400)};
  for (int k = 0; k < 400; ++k) record.output[k] = std::exp(-0.01 * k) * std::cos(0.2 * k);
  const std::optional<Arx> arx = FitArx({&record, 1}, 8);
  ASSERT_TRUE(arx);
  // z = exp(-0.01 +- 0.2 i).
  EXPECT_EQ(arx->order, 2);
  EXPECT_NEAR(arx->own[0], 2 * std::exp(-0.01) * std::cos(0.2), 1e-9);
  EXPECT_NEAR(arx->own[1], -std::exp(-0.02), 1e-9);
}

TEST(Arx, RefusesWhatIsTooShortOrConstant) {
  const ArxRecord brief = Known(50, 0, 1);
  EXPECT_FALSE(FitArx({&brief, 1}, 8));
  const ArxRecord constant{.inputs = Eigen::MatrixXd::Ones(1000, 1), .output = Eigen::VectorXd::Ones(1000)};
  EXPECT_FALSE(FitArx({&constant, 1}, 8));
  EXPECT_FALSE(FitArx({}, 8));
}

TEST(Arx, LinearShareIsOneLessTheShareOfNoise) {
  const ArxRecord clean = Known(40000, 0, 4);
  const double power = (clean.output.array() - clean.output.mean()).square().mean();
  const ArxRecord noisy = Known(40000, std::sqrt(power / 3), 4);
  const std::optional<double> share = LinearShare(noisy, 400);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 0.75, 0.015);  // leakage of a resonance of 11 samples' decay; scatter of 200 averages
  ArxRecord unrelated = noisy;
  unrelated.output = Known(40000, 0, 5).inputs.col(0);
  EXPECT_NEAR(*LinearShare(unrelated, 400), 0, 0.01);
  EXPECT_FALSE(LinearShare(noisy, 20000));
}

}  // namespace
}  // namespace fourpost::arx_test
