#include "vehicles/laws/series_damper.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::series_damper_test {
namespace {

TEST(SeriesDamper, RelaxesWithItsTimeConstants) {
  const SeriesDamper damper{{800, 2600}, {.stiffness = 150e3}};
  EXPECT_DOUBLE_EQ(damper.SpringRate(0, 0.01), -0.01 * 150e3 / 2600);
  EXPECT_DOUBLE_EQ(damper.SpringRate(0, -0.01), 0.01 * 150e3 / 800);
}

TEST(SeriesDamper, SpringRestsWhereItCarriesTheDashpotsForce) {
  // Model 5 of the thesis: cubic spring, smooth dashpot.
  const SeriesDamper damper{DashpotLaw::Smooth(800, 2600, 0.05), {.stiffness = 150e3, .cubic = 5e9}};
  for (const double x : {-0.02, -0.003, 0.0004, 0.01}) {
    const double v = damper.dashpot.Velocity(damper.Force(x));
    EXPECT_EQ(damper.SpringRate(v, x), 0);
    EXPECT_NEAR(damper.dashpot.Force(v), damper.Force(x), 8 * kUlp * std::abs(damper.Force(x)));
  }
}

/// Largest difference from the dashpot's own force over the second cycle of v = cos(2 pi t), over the largest force.
double ShareOfTheSpring(double stiffness) {
  const SeriesDamper damper{{1000, 1000}, {.stiffness = stiffness}};
  const auto rate = [](double t) { return std::cos(2 * std::numbers::pi * t); };
  const double h = 0.1 * 1000 / stiffness;
  const int steps = static_cast<int>(std::lround(2 / h));
  double x = 0;
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    if (2 * k >= steps) largest = std::max(largest, std::abs(damper.Force(x) - damper.dashpot.Force(rate(t))));
    const double k1 = damper.SpringRate(rate(t), x);
    const double k2 = damper.SpringRate(rate(t + h / 2), x + h / 2 * k1);
    const double k3 = damper.SpringRate(rate(t + h / 2), x + h / 2 * k2);
    const double k4 = damper.SpringRate(rate(t + h), x + h * k3);
    x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return largest / 1000;
}

// The force is that of a first-order lag with time constant c/k: its distance is w c/k / sqrt(1 + (w c/k)^2).
TEST(SeriesDamper, StiffSpringIsRigid) {
  for (const double stiffness : {1e5, 1e6, 1e7}) {
    const double lag = 2 * std::numbers::pi * 1000 / stiffness;
    // Runge-Kutta errs by (h k/c)^5 / 120 per step and time constant, a part in 1e6; the peak falls between samples.
    EXPECT_NEAR(ShareOfTheSpring(stiffness) / (lag / std::hypot(1, lag)), 1, 1e-5);
  }
}

}  // namespace
}  // namespace fourpost::series_damper_test
