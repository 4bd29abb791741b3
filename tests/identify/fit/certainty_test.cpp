#include "identify/fit/certainty.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/fit/fit.h"
#include "identify/fit/fitted_parameters.h"
#include "tests/identify/toy_objective.h"

namespace fourpost::certainty_test {
namespace {

constexpr Eigen::Index kCount = 40;

/// p0 + p1 = 2 as data, at every sample; noise that averages out.
VehicleObjective Sum() {
  return ToyObjective(2, kCount, 1e-15, [](const std::vector<double>& p) {
    Eigen::VectorXd residuals(kCount);
    for (Eigen::Index i = 0; i < kCount; ++i) residuals[i] = (p[0] + p[1] - 2) / 0.01 + (i % 2 == 0 ? 1 : -1);
    return residuals;
  });
}

FitResult FitOf(const VehicleObjective& objective) {
  FitOptions options;
  options.stop.max_evaluations = 40;
  options.starts = 1;
  return Fit(objective, options);
}

/// p1 held at 1, known to within its prior.
FitResult WithHeld(std::optional<double> prior_sd, double upper = 5) {
  const VehicleObjective both = Sum();
  Vehicle vehicle = both.vehicle();
  vehicle.parameters[1].prior_sd = prior_sd;
  vehicle.parameters[1].upper = upper;
  if (upper == 1) vehicle.parameters[1].lower = 1;
  return FitOf(VehicleObjective(vehicle, {0}, both.blocks()));
}

// p0 = 2 - p1: it is as uncertain as p1, beside noise of 0.01 / 40^1/2.
TEST(Certainty, CountsWhatIsHeldAsKnownWithinItsPrior) {
  const FitResult fit = WithHeld(0.1);
  ASSERT_TRUE(fit.certainty);
  EXPECT_NEAR(fit.certainty->held_sd[0], 0.1, 1e-4);
  EXPECT_NEAR(fit.certainty->noise_sd[0], 0.01 / std::sqrt(double{kCount}), 2e-4);
  EXPECT_EQ(fit.certainty->LimitedBy(0), "held: p1");
}

// Evenly within 0.2 .. 5 in its logarithm.
TEST(Certainty, CountsWhatIsHeldAsAnywhereInItsRangeWithoutAPrior) {
  const FitResult fit = WithHeld(std::nullopt);
  ASSERT_TRUE(fit.certainty);
  EXPECT_NEAR(fit.certainty->held_sd[0], std::log(25.0) / std::sqrt(12.0), 1e-3);
}

TEST(Certainty, CountsWhatHasNoRangeAsExact) {
  const FitResult fit = WithHeld(std::nullopt, 1);
  ASSERT_TRUE(fit.certainty);
  EXPECT_EQ(fit.certainty->held_sd[0], 0);
  EXPECT_EQ(fit.certainty->LimitedBy(0), "noise");
}

Vehicle WithRatio(Vehicle vehicle, double sd) {
  vehicle.parameters[1].like = Parameter::Likeness{"p0", sd};
  return vehicle;
}

// The data know the sum of both logarithms to 0.01 / 40^1/2, the ratio is known to 0.3, and each is half of both.
TEST(Certainty, CountsWhatIsKnownOfARatio) {
  const VehicleObjective both = Sum();
  const FitResult fit = FitOf(VehicleObjective(WithRatio(both.vehicle(), 0.3), both.free(), both.blocks()));
  ASSERT_TRUE(fit.certainty);
  const double sd = 0.5 * std::hypot(0.3, 0.01 / std::sqrt(double{kCount}));
  EXPECT_NEAR(fit.certainty->noise_sd[0], sd, 1e-3);
  EXPECT_NEAR(fit.certainty->noise_sd[1], sd, 1e-3);
}

/// p0 = 1 in one part of the data, and p1 = 0.6, 0.8, 1.2 and 1.4 in four others.
VehicleObjective Contradicting(std::optional<double> like_sd) {
  constexpr std::array<double, 5> kSays = {1, 0.6, 0.8, 1.2, 1.4};
  const VehicleObjective toy = ToyObjective(2, 5 * kCount, 1e-15, [=](const std::vector<double>& p) {
    Eigen::VectorXd residuals(5 * kCount);
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
      const auto part = static_cast<std::size_t>(i / kCount);
      residuals[i] = (p[part == 0 ? 0 : 1] - kSays[part]) / 0.01 + (i % 2 == 0 ? 1 : -1);
    }
    return residuals;
  });
  std::vector<ResidualBlock> blocks = toy.blocks();
  blocks[0].structure.partitions = {{"parts", {}, {}}};
  for (int part = 0; part < 5; ++part) blocks[0].structure.partitions[0].Add(std::to_string(part), kCount);
  return {like_sd ? WithRatio(toy.vehicle(), *like_sd) : toy.vehicle(), toy.free(), blocks};
}

TEST(Certainty, AModelMovesAParameterNoFartherThanItsRatioMayBeOff) {
  const FitResult alone = FitOf(Contradicting(std::nullopt));
  ASSERT_TRUE(alone.certainty);
  EXPECT_GT(alone.certainty->model_sd[1], 0.2);
  const FitResult alike = FitOf(Contradicting(0.05));
  ASSERT_TRUE(alike.certainty);
  EXPECT_NEAR(alike.certainty->model_sd[1], std::hypot(alike.certainty->model_sd[0], 0.05), 1e-9);
}

TEST(Certainty, NamesWhatIsHeldOutsideItsRange) {
  const VehicleObjective both = Sum();
  Vehicle vehicle = both.vehicle();
  vehicle.parameters[1].lower = 1.5;
  const FitResult fit = FitOf(VehicleObjective(vehicle, {0}, both.blocks()));
  ASSERT_TRUE(fit.certainty);
  EXPECT_EQ(fit.certainty->held_left_out, std::vector<std::string>{"p1"});
  EXPECT_EQ(fit.certainty->held_sd[0], 0);
}

// A fifth of the model error stands for what all parts of the data have in common, which is then known; what is left
// contradicts itself no more.
TEST(Certainty, WhatIsMissingTakesThePlaceOfErrorsInCommon) {
  Certainty certainty;
  certainty.covariance.reach_95 = 2;
  certainty.judged = {0};
  certainty.noise_sd = certainty.held_sd = Eigen::VectorXd::Zero(1);
  certainty.model_sd = certainty.total_sd = Eigen::VectorXd::Constant(1, kErrorInCommon);
  certainty.model_error.covariance = certainty.total_covariance = Eigen::MatrixXd::Constant(1, 1, 1.44);
  const ModelErrorEstimate left = {.reach = Eigen::VectorXd::Zero(1), .covariance = Eigen::MatrixXd::Zero(1, 1)};
  certainty.AllowForMissing({"friction"}, Eigen::MatrixXd::Zero(1, 1), left);
  EXPECT_NEAR(certainty.model_sd[0], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(certainty.total_covariance(0, 0), 0.5, 1e-12);
}

// p1 and p2 are held; the model breaks wherever p2 is not 1.
TEST(Certainty, LeavesOutOnlyWhatCannotBeEvaluated) {
  const VehicleObjective all = ToyObjective(3, kCount, 1e-15, [](const std::vector<double>& p) {
    Eigen::VectorXd residuals = Eigen::VectorXd::Constant(kCount, (p[0] + p[1] - 2) / 0.01);
    for (Eigen::Index i = 0; i < kCount; ++i) residuals[i] += i % 2 == 0 ? 1 : -1;
    if (p[2] != 1) residuals[0] = std::nan("");
    return residuals;
  });
  const FitResult fit = FitOf(VehicleObjective(all.vehicle(), {0}, all.blocks()));
  ASSERT_TRUE(fit.certainty);
  EXPECT_EQ(fit.certainty->held, std::vector<std::string>{"p1"});
  EXPECT_EQ(fit.certainty->held_left_out, std::vector<std::string>{"p2"});
  EXPECT_NEAR(fit.certainty->held_sd[0], std::log(25.0) / std::sqrt(12.0), 1e-3);
}

// What would be missing from its intervals nobody can see.
TEST(Certainty, AFitThatIsStoppedOnTheWayToItHasNone) {
  const VehicleObjective both = Sum();
  bool is_stopped = false;
  FitOptions options;
  options.stop.max_evaluations = 40;
  options.starts = 1;
  const FitHooks hooks{.progress = [&](const FitProgress& now) { is_stopped = now.stage == "deviations"; },
                       .stop = [&] { return is_stopped; }};
  const VehicleObjective one(both.vehicle(), {0}, both.blocks());
  const FitResult fit = Fit(one, options, hooks);
  ASSERT_TRUE(is_stopped);
  EXPECT_EQ(fit.end, FitEnd::kInterrupted);
  EXPECT_FALSE(fit.certainty);
  EXPECT_FALSE(fit.covariance);
  EXPECT_NEAR(fit.parameters[0].value, 1, 1e-3);  // of 0.01 / 40^1/2
  EXPECT_EQ(fit.parameters[0].state, ParameterState::kNotComputed);
}

// Anywhere between the value and where it would be with what is missing: delta^2 / 3 about one end.
TEST(Certainty, ReachesToWhereMissingPhysicsTakesAParameter) {
  const VehicleObjective both = Sum();
  Vehicle vehicle = both.vehicle();
  vehicle.parameters[1].lower = vehicle.parameters[1].upper = 1;
  const VehicleObjective one(vehicle, {0}, both.blocks());
  FitResult fit = FitOf(one);
  ASSERT_TRUE(fit.certainty);
  const FittedParameter before = fit.parameters[0];
  constexpr double kMoved = 0.3;
  AllowForMissing(one,
                  {.names = {"friction"},
                   .moved = Eigen::MatrixXd::Constant(1, 1, kMoved),
                   .residuals = Eigen::VectorXd::Zero(kCount),
                   .jacobian = Eigen::MatrixXd::Constant(kCount, 1, 100)},
                  fit);
  const FittedParameter& after = fit.parameters[0];
  EXPECT_EQ(after.value, before.value);
  EXPECT_NEAR(after.lower_95, before.lower_95, 1e-9);
  EXPECT_NEAR(after.upper_95, before.upper_95 * std::exp(kMoved), 1e-6);
  EXPECT_NEAR(after.sd / after.value, std::hypot(before.sd / before.value, kMoved / std::sqrt(3)), 1e-6);
  EXPECT_NEAR(fit.certainty->total_covariance(0, 0), std::pow(fit.certainty->total_sd[0], 2), 1e-9);
  EXPECT_EQ(after.limited_by, "missing: friction");
}

}  // namespace
}  // namespace fourpost::certainty_test
