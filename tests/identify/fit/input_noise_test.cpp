#include "identify/fit/input_noise.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "analysis/signals/random_stream.h"
#include "identify/fit/fit.h"
#include "tests/identify/toy_objective.h"

namespace fourpost::input_noise_test {
namespace {

constexpr double kTrue = 2;
constexpr double kNoise = 0.2;
constexpr Eigen::Index kSamples = 20000;

Eigen::VectorXd Noise(std::uint64_t seed) {
  RandomStream draws(seed, "input");
  Eigen::VectorXd noise(kSamples);
  for (double& value : noise) value = kNoise * draws.Normal();
  return noise;
}

/// y = p u of an exact output; the input was recorded with noise.
ResidualBlock Gain(const Eigen::VectorXd& input, const Eigen::VectorXd& output) {
  return {.name = "gain",
          .count = input.size(),
          .evaluate = [=](const std::vector<double>& values,
                          const Deadline&) { return Evaluation{.residuals = values[0] * input - output}; },
          .with_input_noise =
              [=](const std::vector<double>&) {
                return std::vector{Gain(input - Noise(99), output), Gain(input + Noise(99), output)};
              }};
}

FitResult FitOf(const ResidualBlock& block) {
  const VehicleObjective toy = ToyObjective(1, kSamples, 1e-15, {});
  const VehicleObjective objective(toy.vehicle(), toy.free(), {block});
  FitOptions options;
  options.stop.max_evaluations = 10;
  options.starts = 0;
  options.threads = 1;
  return Fit(objective, options);
}

Eigen::VectorXd Sine() {
  Eigen::VectorXd input(kSamples);
  for (Eigen::Index k = 0; k < kSamples; ++k) input[k] = std::numbers::sqrt2 * std::sin(0.37 * static_cast<double>(k));
  return input;
}

// Least squares give p / (1 + s), s the noise's share of the input's squares.
TEST(InputNoise, TakesBackWhatItMovedTheOptimumBy) {
  const Eigen::VectorXd input = Sine();
  const FitResult fit = FitOf(Gain(input + Noise(1), kTrue * input));
  ASSERT_EQ(fit.end, FitEnd::kConverged) << fit.message;
  const double plain = fit.parameters[0].value * std::exp(-fit.moved_by_input_noise[0]);
  // Both scatter by the noise over the root of the samples, 0.15 %.
  EXPECT_NEAR(plain, kTrue / (1 + kNoise * kNoise), 0.01);
  EXPECT_NEAR(fit.parameters[0].value, kTrue, 0.015);
  EXPECT_GT(fit.evaluations_beside, 0);
  EXPECT_FALSE(fit.is_input_noise_implausible);
  // p s at every sample, by chance to 1 %; nothing else is in the residuals.
  const double squares = plain * plain * kNoise * kNoise * kSamples;
  EXPECT_NEAR(fit.input_noise_squares, squares, 0.03 * squares);
  EXPECT_TRUE(fit.IsMostlyInputNoise());
  EXPECT_NEAR(fit.Misfit(), std::sqrt(fit.data_squares / (squares + kSamples)), 0.003);
}

// As where what the model lacks was taken for noise: of five times the size of the motion.
TEST(InputNoise, DoesNotMoveTheOptimumByMoreThanNoiseCan) {
  const Eigen::VectorXd input = Sine();
  ResidualBlock block = Gain(input + Noise(1), kTrue * input);
  block.with_input_noise = [=](const std::vector<double>&) {
    return std::vector{Gain(input - 25 * Noise(99), kTrue * input), Gain(input + 25 * Noise(99), kTrue * input)};
  };
  const FitResult fit = FitOf(block);
  ASSERT_EQ(fit.end, FitEnd::kConverged) << fit.message;
  EXPECT_NEAR(fit.parameters[0].value, kTrue / (1 + kNoise * kNoise), 0.01);
  EXPECT_EQ(fit.moved_by_input_noise.size(), 0);
  EXPECT_TRUE(fit.is_input_noise_implausible);
}

}  // namespace
}  // namespace fourpost::input_noise_test
