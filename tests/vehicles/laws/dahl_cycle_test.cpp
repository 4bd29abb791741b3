#include "vehicles/laws/dahl_cycle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::dahl_cycle_test {
namespace {

constexpr DahlFriction kSeal{.force = 60, .stiffness = 2e5};
constexpr double kLength = kSeal.force / kSeal.stiffness;

/// From -amplitude to amplitude and back, the turning points among the samples.
std::vector<double> Triangle(double amplitude, std::size_t half) {
  std::vector<double> x;
  for (std::size_t k = 0; k < 2 * half; ++k) {
    const double share = static_cast<double>(k < half ? k : 2 * half - k) / static_cast<double>(half);
    x.push_back(amplitude * (2 * share - 1));
  }
  return x;
}

/// Of a closed path.
double Loss(const std::vector<double>& x, const std::vector<double>& force) {
  double loss = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t next = (k + 1) % x.size();
    loss += 0.5 * (force[k] + force[next]) * (x[next] - x[k]);
  }
  return loss;
}

TEST(DahlCycle, FollowsTheClosedLoopOfATriangle) {
  for (const double amplitude : {0.01 * kLength, kLength, 30 * kLength}) {
    const std::vector<double> x = Triangle(amplitude, 50);
    const DahlCycle cycle(kSeal, x);
    const double turning = kSeal.force * std::tanh(amplitude / kLength);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double sign = k <= 50 ? 1 : -1;
      const double along = amplitude + sign * x[k];
      const double expected = sign * (kSeal.force - (kSeal.force + turning) * std::exp(-along / kLength));
      // Rounding, of the force that repeats over what is forgotten in a cycle.
      EXPECT_NEAR(cycle.forces()[k], expected, 200 * kUlp * kSeal.force * std::max(1.0, kLength / amplitude));
    }
  }
}

TEST(DahlCycle, LosesWhatTheClosedFormSays) {
  for (const double amplitude : {0.2 * kLength, kLength, 10 * kLength}) {
    const std::vector<double> x = Triangle(amplitude, 4000);
    const double exact = 4 * kSeal.force * (amplitude - kLength * std::tanh(amplitude / kLength));
    // The trapezoidal rule errs by h^2 / 12 of the curvature: of the loop by less than the square of a stroke.
    const double step = 2 * amplitude / 4000 / kLength;
    EXPECT_NEAR(Loss(x, DahlCycle(kSeal, x).forces()), exact, step * step * kSeal.force * kLength);
  }
}

TEST(DahlCycle, DependsOnThePathAlone) {
  // A triangle and a sine over the same turning points, at the same places.
  const double amplitude = 2 * kLength;
  std::vector<double> sine;
  for (std::size_t k = 0; k < 200; ++k)
    sine.push_back(-amplitude * std::cos(std::numbers::pi / 100 * static_cast<double>(k)));
  const DahlCycle cycle(kSeal, sine);
  const double turning = kSeal.force * std::tanh(amplitude / kLength);
  EXPECT_NEAR(cycle.forces()[100], turning, 200 * kUlp * kSeal.force);
  EXPECT_NEAR(cycle.forces()[0], -turning, 200 * kUlp * kSeal.force);
  EXPECT_NEAR(cycle.forces()[50], kSeal.force - (kSeal.force + turning) * std::exp(-2.0), 200 * kUlp * kSeal.force);
}

/// Two waves with small loops in the large one.
std::vector<double> Wave(double shift, std::size_t place) {
  std::vector<double> x;
  for (std::size_t k = 0; k < 64; ++k) {
    const double phase = std::numbers::pi / 32 * static_cast<double>(k);
    x.push_back(kLength * (2 * std::cos(phase) + std::sin(5 * phase)) + (k == place ? shift : 0));
  }
  return x;
}

TEST(DahlCycle, ChangesAsItsDifferences) {
  constexpr double kStep = 1e-6 * kLength;
  const DahlCycle cycle(kSeal, Wave(0, 0));
  for (const std::size_t place : {std::size_t{0}, std::size_t{7}, std::size_t{63}}) {
    std::vector<double> one(64);
    one[place] = 1;
    std::vector<double> change(64);
    cycle.Change(one, change);
    const DahlCycle above(kSeal, Wave(kStep, place));
    const DahlCycle below(kSeal, Wave(-kStep, place));
    for (std::size_t k = 0; k < 64; ++k)
      EXPECT_NEAR(change[k], (above.forces()[k] - below.forces()[k]) / (2 * kStep), 1e-7 * kSeal.stiffness);
  }
}

TEST(DahlCycle, IsZeroWithoutMotionOrForce) {
  const std::vector<double> still(8, 0.01);
  const DahlCycle at_rest(kSeal, still);
  EXPECT_EQ(at_rest.forces(), std::vector<double>(8));
  std::vector<double> change(8, 1);
  at_rest.Change(std::vector<double>(8), change);
  EXPECT_EQ(change, std::vector<double>(8));
  EXPECT_EQ(DahlCycle({.force = 0, .stiffness = 1e5}, Wave(0, 0)).forces(), std::vector<double>(64));
}

}  // namespace
}  // namespace fourpost::dahl_cycle_test
