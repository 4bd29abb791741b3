#include "vehicles/laws/dahl_friction.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/rounding.h"
#include "vehicles/laws/dahl_cycle.h"

namespace fourpost::dahl_friction_test {
namespace {

constexpr DahlFriction kSeal{.force = 60, .stiffness = 2e5};
/// Over which friction comes to 1 - 1/e of the sliding force [m].
constexpr double kLength = kSeal.force / kSeal.stiffness;

TEST(DahlFriction, IsASpringFromRestAndThenSlides) {
  EXPECT_NEAR(kSeal.After(0, 1e-4 * kLength).force, 1e-4 * kSeal.force, 0.5e-4 * 1e-4 * kSeal.force);
  EXPECT_DOUBLE_EQ(kSeal.After(0, 0).by_extension, kSeal.stiffness);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_DOUBLE_EQ(kSeal.After(0, sign * kLength).force, sign * kSeal.force * (1 - std::exp(-1.0)));
    EXPECT_DOUBLE_EQ(kSeal.After(-sign * kSeal.force, sign * 50 * kLength).force, sign * kSeal.force);
  }
}

TEST(DahlFriction, IsTheSameInOneStrokeOrInMany) {
  double force = -20;
  for (int k = 0; k < 100; ++k) force = kSeal.After(force, 0.03 * kLength).force;
  EXPECT_NEAR(force, kSeal.After(-20, 3 * kLength).force, 100 * kUlp * kSeal.force);
}

/// F' = stiffness (x' - |x'| F / force) by Runge and Kutta's fourth order, whose steps of 1/100 of kLength err by less
/// than (1/100)^4 of the sliding force.
TEST(DahlFriction, SolvesItsEquation) {
  for (const double v : {-0.3, 0.02}) {
    const double h = 0.01 * kLength / std::abs(v);
    double force = 25;
    for (int k = 0; k < 200; ++k) {
      const double k1 = kSeal.Rate(v, force);
      const double k2 = kSeal.Rate(v, force + 0.5 * h * k1);
      const double k3 = kSeal.Rate(v, force + 0.5 * h * k2);
      const double k4 = kSeal.Rate(v, force + h * k3);
      force += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    EXPECT_NEAR(force, kSeal.After(25, 200 * h * v).force, 1e-8 * kSeal.force);
  }
}

TEST(DahlFriction, HasTheSlopesOfItsDifferences) {
  constexpr double kStep = 1e-6;  // relative; central differences err by its square and by rounding over it
  for (const double start : {-59.0, -20.0, 0.0, 35.0})
    for (const double stroke : {-2 * kLength, -0.3 * kLength, 0.01 * kLength, 4 * kLength}) {
      const DahlFriction::Stroke found = kSeal.After(start, stroke);
      const double by_extension =
          (kSeal.After(start, stroke + kStep * kLength).force - kSeal.After(start, stroke - kStep * kLength).force) /
          (2 * kStep * kLength);
      const double by_force =
          (kSeal.After(start + kStep, stroke).force - kSeal.After(start - kStep, stroke).force) / (2 * kStep);
      EXPECT_NEAR(found.by_extension, by_extension, 1e-8 * kSeal.stiffness);
      EXPECT_NEAR(found.by_force, by_force, 1e-7);
      EXPECT_GE(found.by_extension, 0);
      EXPECT_LE(found.by_extension, 2 * kSeal.stiffness);
    }
}

// Against the exact cycle: of samples that the trapezoidal rule takes to the second order.
TEST(DahlFriction, HasTheGainOfItsCycle) {
  constexpr int kSamples = 20000;
  for (const double amplitude : {1e-5 * kLength, 0.01 * kLength, kLength, 10 * kLength, 59 * kLength, 61 * kLength}) {
    std::vector<double> extension;
    for (int k = 0; k < kSamples; ++k) extension.push_back(amplitude * std::cos(2 * std::numbers::pi * k / kSamples));
    const DahlCycle cycle(kSeal, extension);
    std::complex<double> gain = 0;
    for (int k = 0; k < kSamples; ++k)
      gain += cycle.forces()[static_cast<std::size_t>(k)] *
              std::polar(2.0 / kSamples / amplitude, -2 * std::numbers::pi * k / kSamples);
    EXPECT_LT(std::abs(kSeal.Gain(amplitude) - gain), 2e-6 * std::abs(gain)) << amplitude / kLength;
  }
  EXPECT_EQ(kSeal.Gain(0), kSeal.stiffness);
}

TEST(DahlFriction, WithoutForceIsNothing) {
  const DahlFriction none{.force = 0, .stiffness = 2e5};
  EXPECT_EQ(none.After(0, 0).force, 0);
  EXPECT_EQ(none.After(0, 1).force, 0);
  EXPECT_EQ(none.Rate(1, 0), 0);
  EXPECT_NO_THROW(none.Validate());
}

TEST(DahlFriction, RefusesImpossibleNumbers) {
  EXPECT_THROW((DahlFriction{.force = -1, .stiffness = 1}.Validate()), std::invalid_argument);
  EXPECT_THROW((DahlFriction{.force = kNan, .stiffness = 1}.Validate()), std::invalid_argument);
  EXPECT_THROW((DahlFriction{.force = 1, .stiffness = 0}.Validate()), std::invalid_argument);
  EXPECT_THROW((DahlFriction{.force = 1, .stiffness = kInfinity}.Validate()), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::dahl_friction_test
