#include "vehicles/simulation/hydraulic_step.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/hydraulic_settings.h"

namespace fourpost::hydraulic_step_test {
namespace {

constexpr double kEnd_s = 0.5;

/// Starts from rest: 15 mm at 4 Hz.
double Extension(double t) { return 0.0075 * (1 - std::cos(2 * std::numbers::pi * 4 * t)); }
double Rate(double t) { return 0.0075 * 2 * std::numbers::pi * 4 * std::sin(2 * std::numbers::pi * 4 * t); }

class HydraulicSteps : public testing::TestWithParam<HydraulicSetting> {};

/// Tension at every hundredth of the time, by the damper's own pressures and by steps.
std::vector<double> ByPressures(const MountedHydraulicDamper& law) {
  std::array<double, 2> p = law.damper.Rest();
  const auto rates = [&](double t, const std::array<double, 2>& at) {
    return law.HasMount() ? law.PressureRates(Extension(t), Rate(t), at)
                          : law.damper.PressureRates(Extension(t), Rate(t), at);
  };
  const auto along = [&p](double h, const std::array<double, 2>& rate) {
    return std::array<double, 2>{p[0] + h * rate[0], p[1] + h * rate[1]};
  };
  constexpr int kSteps = 100000;
  constexpr double h = kEnd_s / kSteps;
  std::vector<double> tensions;
  for (int k = 0; k < kSteps; ++k) {
    const double t = h * k;
    const auto k1 = rates(t, p);
    const auto k2 = rates(t + h / 2, along(h / 2, k1));
    const auto k3 = rates(t + h / 2, along(h / 2, k2));
    const auto k4 = rates(t + h, along(h, k3));
    for (std::size_t i = 0; i < 2; ++i) p[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    if ((k + 1) % (kSteps / 100) == 0) tensions.push_back(law.damper.Force(0, p));
  }
  return tensions;
}

double Error(const MountedHydraulicDamper& law, const std::vector<double>& exact, int steps_per_sample) {
  HydraulicStep step({.law = law, .share = {}}, kEnd_s / 100 / steps_per_sample);
  double error = 0;
  double size = 0;
  for (int k = 1; k <= 100 * steps_per_sample; ++k) {
    const double tension = step.Remainder(Extension(kEnd_s * k / (100 * steps_per_sample)), 0);
    step.Advance();
    if (k % steps_per_sample > 0) continue;
    const double expected = exact[static_cast<std::size_t>(k / steps_per_sample - 1)];
    error += (tension - expected) * (tension - expected);
    size += expected * expected;
  }
  return std::sqrt(error / size);
}

TEST_P(HydraulicSteps, FollowTheDampersOwnPressuresToTheSecondOrder) {
  const MountedHydraulicDamper& law = GetParam().damper;
  const std::vector<double> exact = ByPressures(law);
  const double coarse = Error(law, exact, 5);
  const double fine = Error(law, exact, 40);
  // 1 ms of a cycle of 250 ms: (2 pi / 250)^2 / 3 of each harmonic times its order squared; vapour that collapses falls
  // between two steps.
  EXPECT_LT(coarse, 0.05);
  // An eighth of the step; valves open, and vapour collapses, within one.
  EXPECT_LT(fine, coarse / 15);
}

TEST_P(HydraulicSteps, KnowTheirSlopes) {
  HydraulicStep step({.law = GetParam().damper, .share = {.stiffness = 2000, .rate = 0, .series = 3e5}}, 1e-3);
  for (int k = 1; k <= 20; ++k) {
    step.Remainder(Extension(1e-3 * k), 1e-4);
    step.Advance();
  }
  const double at = Extension(0.021);
  constexpr double kSmall = 1e-7;
  const double above = step.Remainder(at + kSmall, 1e-4);
  const double below = step.Remainder(at - kSmall, 1e-4);
  const double further = step.Remainder(at - kSmall, 1e-4 + kSmall);
  step.Remainder(at, 1e-4);
  // Curvature over 0.1 um.
  EXPECT_NEAR(step.ByExtension(), (above - below) / (2 * kSmall), 1e-3 * std::abs(step.ByExtension()));
  EXPECT_NEAR(step.ByLag(), (further - below) / kSmall, 1e-3 * std::abs(step.ByLag()));
}

TEST_P(HydraulicSteps, HaveNoAnswerWhereAChamberIsClosed) {
  if (GetParam().damper.HasMount()) return;
  HydraulicStep step({.law = GetParam().damper, .share = {}}, 1e-3);
  EXPECT_TRUE(std::isnan(step.Remainder(0.11, 0)));
  EXPECT_TRUE(std::isfinite(step.Remainder(0.01, 0)));
}

INSTANTIATE_TEST_SUITE_P(Settings, HydraulicSteps, testing::ValuesIn(HydraulicSettings()),
                         [](const auto& setting) { return setting.param.name; });

}  // namespace
}  // namespace fourpost::hydraulic_step_test
