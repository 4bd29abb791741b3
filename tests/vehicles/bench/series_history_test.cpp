#include "vehicles/bench/series_history.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "analysis/signals/fit_quality.h"

namespace fourpost::series_history_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A sweep from 1 to 20 Hz, 4 s at 500 Hz, of 0.3 m/s at the most.
double Sweep(double t) {
  const double phase = 2 * kPi * (t + 19 * t * t / 8);
  return 0.3 / (2 * kPi * (1 + 19 * t / 4)) * std::sin(phase) * std::min(1.0, 2 * t);
}

BenchMotion SweepMotion() {
  std::vector<double> x;
  for (int k = 0; k < 2000; ++k) x.push_back(Sweep(0.002 * k));
  return MotionThrough(x, 0.002);
}

/// The same equations by the classical Runge-Kutta method in a hundredth of a step, on the same spline.
std::vector<double> Reference(const SeriesDamper& damper, const BenchMotion& motion) {
  constexpr int kFiner = 100;
  std::vector<double> forces = {0};
  double y = 0;
  const double h = motion.step_s / kFiner;
  for (std::size_t k = 0; k + 1 < motion.extension.size(); ++k) {
    // Within a step the rate is a parabola.
    const auto rate = [&](double s) {
      const double t = s * motion.step_s;
      return motion.rate[k] + motion.acceleration[k] * t +
             (motion.acceleration[k + 1] - motion.acceleration[k]) / motion.step_s * t * t / 2;
    };
    for (int j = 0; j < kFiner; ++j) {
      const double start = static_cast<double>(j) / kFiner;
      const double middle = (j + 0.5) / kFiner;
      const double end = (j + 1.0) / kFiner;
      const double k1 = damper.SpringRate(rate(start), y);
      const double k2 = damper.SpringRate(rate(middle), y + 0.5 * h * k1);
      const double k3 = damper.SpringRate(rate(middle), y + 0.5 * h * k2);
      const double k4 = damper.SpringRate(rate(end), y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    if ((k + 1) % motion.steps == 0) forces.push_back(damper.Force(y));
  }
  return forces;
}

struct Case {
  std::string name;
  SeriesDamper damper;
  /// Of the force's rms.
  double error = 0;
};

class SeriesHistory : public testing::TestWithParam<Case> {};

TEST_P(SeriesHistory, IsThatOfTheEquations) {
  const BenchMotion motion = SweepMotion();
  const std::vector<double> expected = Reference(GetParam().damper, motion);
  const double error_percent = NormalisedMse_percent(expected, SeriesForces(GetParam().damper, motion));
  EXPECT_LT(std::sqrt(error_percent / 100), GetParam().error);
}

// Errors measured, times two.
INSTANTIATE_TEST_SUITE_P(
    Laws, SeriesHistory,
    testing::Values(
        Case{"model3", {DashpotLaw(750, 1910), {.stiffness = 6e5}}, 3e-8},
        Case{"stiff", {DashpotLaw(750, 1910), {.stiffness = 4e6}}, 7e-8},
        Case{"model4", {DashpotLaw(750, 1910), {.stiffness = 3e5, .cubic = 1.7e12}}, 5e-5},
        Case{"model5", {DashpotLaw::Smooth(750, 1910, 0.06), {.stiffness = 3e5, .cubic = 1.6e12}}, 2e-6},
        Case{"knees", {DashpotLaw::Digressive(1000, 2000, {0.05, 620}, {0.2, 1460}), {.stiffness = 6e5}}, 3e-8},
        Case{"friction",
             {DashpotLaw::Digressive(1000, 2000, {0.05, 620}, {0.2, 1460}).WithFriction(25, 0.003),
              {.stiffness = 4e5, .cubic = 1e12}},
             4e-5},
        Case{"table", {DashpotLaw::Table({-0.3, -0.1, 0.1, 0.3}, {-250, -110, 210, 560}), {.stiffness = 6e5}}, 3e-6}),
    [](const auto& curve) { return curve.param.name; });

// A linear dashpot of rate c on a spring k at frequency w: force c i w x / (1 + i w c / k).
TEST(SeriesHistoryLinear, HasTheGainAndTheLagOfTheMaxwellElement) {
  constexpr double kRate = 1500;
  constexpr double kStiffness = 6e5;
  constexpr double kFrequency = 20;
  const double w = 2 * kPi * kFrequency;
  std::vector<double> x;
  for (int k = 0; k <= 1000; ++k) x.push_back(1e-3 * std::sin(w * 0.002 * k));
  const std::vector<double> force =
      SeriesForces({DashpotLaw(kRate, kRate), {.stiffness = kStiffness}}, MotionThrough(x, 0.002));
  const double ratio = w * kRate / kStiffness;
  const double gain = 1e-3 * w * kRate / std::sqrt(1 + ratio * ratio);
  const double lead = kPi / 2 - std::atan(ratio);
  // The spline's rate at 25 samples a period errs by 2e-5.
  for (std::size_t k = 500; k < 1000; ++k)
    EXPECT_NEAR(force[k], gain * std::sin(w * 0.002 * static_cast<double>(k) + lead), 1e-4 * gain);
}

// On a rigid mount the dashpot is alone.
TEST(SeriesHistoryLinear, TendsToTheDashpotAlone) {
  const BenchMotion motion = SweepMotion();
  const DashpotLaw law(750, 1910);
  const std::vector<double> forces = SeriesForces({law, {.stiffness = 1e9}}, motion);
  for (std::size_t k = 0; k < forces.size(); ++k)
    ASSERT_NEAR(forces[k], law.Force(motion.rate[k * motion.steps]), 3) << "sample " << k;
}

TEST(SeriesHistoryAtRest, HasNoForce) {
  const BenchMotion motion = MotionThrough(std::vector<double>(50, 0.01), 0.002);
  for (const DashpotLaw& law : {DashpotLaw(750, 1910), DashpotLaw(750, 1910).WithFriction(270, 0.002)})
    // What rounding of the spline's rates leaves, some 1e-13 N.
    for (const double force : SeriesForces({law, {.stiffness = 4e6}}, motion)) ASSERT_NEAR(force, 0, 1e-9);
}

}  // namespace
}  // namespace fourpost::series_history_test
