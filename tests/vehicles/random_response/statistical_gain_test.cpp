#include "vehicles/random_response/statistical_gain.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::statistical_gain_test {
namespace {

using std::numbers::pi;

/// Gauss's rule of eight points on panels of 1.6 deviations.
constexpr double kRounding = 1e-11;

/// E[f(z)] of a standard normal z by the trapezoidal rule in steps of 1e-4: for a kinked f to 1e-8 of its slope.
double NormalMean(const std::function<double(double)>& f) {
  double mean = 0;
  for (int k = -90000; k <= 90000; ++k) {
    const double z = 1e-4 * k;
    mean += 1e-4 * f(z) * std::exp(-0.5 * z * z) / std::sqrt(2 * pi);
  }
  return mean;
}

TEST(StatisticalGain, OfABilinearDamperIsItsMeanRateAndJacks) {
  const DashpotLaw law(800, 2600);
  const StatisticalGain gain = GainOf(DashpotRemainder{law, 1700}, {.extension_sd = 0.01, .rate_sd = 0.3});
  EXPECT_NEAR(gain.by_rate, 0, 1700 * kRounding);
  EXPECT_EQ(gain.by_extension, 0);
  EXPECT_NEAR(gain.mean, 1800 * 0.3 / std::sqrt(2 * pi), 540 * kRounding);
}

// Friction of 100 N whose transition is a thousandth of the rate's deviation: F sqrt(2 / pi) / deviation, less by the
// order of the square of that share.
TEST(StatisticalGain, OfFrictionFallsWithTheMotion) {
  const DashpotLaw law = DashpotLaw(0, 0).WithFriction(100, 1e-4);
  const StatisticalGain gain = GainOf(DashpotRemainder{law, 0}, {.extension_sd = 0.01, .rate_sd = 0.1});
  const double expected = 100 * std::sqrt(2 / pi) / 0.1;
  EXPECT_NEAR(gain.by_rate, expected, 1e-5 * expected);
  EXPECT_NEAR(gain.mean, 0, 1e-10);
}

// At rest a spring; sliding, over a thousand of its lengths, friction of any transition, and little of a spring.
TEST(StatisticalGain, OfFrictionThatSticksGoesFromASpringToFriction) {
  const FrictionRemainder seal{{.force = 100, .stiffness = 1e6}};
  const StatisticalGain at_rest = GainOf(seal, {});
  EXPECT_EQ(at_rest.by_extension, 1e6);
  EXPECT_EQ(at_rest.by_rate, 0);
  const StatisticalGain small = GainOf(seal, {.mean = 0.01, .extension_sd = 1e-8, .rate_sd = 1e-7});
  EXPECT_NEAR(small.by_extension, 1e6, 10);
  // Of a cycle 1 - tanh(a) / a, a the amplitude over the length, is left to rub.
  const StatisticalGain large = GainOf(seal, {.extension_sd = 0.1, .rate_sd = 1});
  const double friction = 100 * std::sqrt(2 / pi);
  EXPECT_NEAR(large.by_rate, friction, 2e-3 * friction);
  EXPECT_EQ(large.mean, 0);
  // The mean over Rayleigh's amplitudes z of 4 F / sqrt(2 pi a) z / 2, a: 1000 z.
  const double spring = NormalMean([](double z) {
                          return z > 0 ? std::sqrt(2 * pi) * z * 0.5 * z * 4 / std::sqrt(2 * pi * 1000 * z) : 0;
                        }) *
                        100 / 0.1;
  EXPECT_NEAR(large.by_extension, spring, 2e-3 * spring);
  EXPECT_EQ(GainOf(FrictionRemainder{{.force = 0, .stiffness = 1e6}}, {}).by_extension, 0);
}

TEST(StatisticalGain, OfADigressiveDamperIsTheAverage) {
  const DashpotLaw law = DashpotLaw::Digressive(1000, 3000, {0.1, 300}, {0.15, 500});
  for (const double deviation : {0.01, 0.1, 1.0}) {
    const StatisticalGain gain = GainOf(DashpotRemainder{law, 1650}, {.extension_sd = 0.01, .rate_sd = deviation});
    const double rate = NormalMean([&](double z) { return law.Force(z * deviation) * z / deviation; });
    EXPECT_NEAR(gain.by_rate, rate - 1650, 1e-7 * rate) << deviation;
    const double mean = NormalMean([&](double z) { return law.Force(z * deviation); });
    EXPECT_NEAR(gain.mean, mean, 1e-7 * rate * deviation) << deviation;
  }
}

TEST(StatisticalGain, OfACubicSpringAboutAMean) {
  const SpringLaw law{.stiffness = 2e4, .cubic = 5e6, .knees = {}};
  const double d = 0.02;
  const double m = 0.01;
  const StatisticalGain gain = GainOf(SpringRemainder{law, 2e4}, {.mean = m, .extension_sd = d, .rate_sd = 1});
  EXPECT_NEAR(gain.by_extension, 3 * 5e6 * (m * m + d * d), 7500 * kRounding);
  EXPECT_NEAR(gain.mean, 5e6 * (m * m * m + 3 * m * d * d), 65 * kRounding);
  EXPECT_EQ(gain.by_rate, 0);
}

// A stop of rate k beyond a gap g: k Phi(-g / d), and its mean force k (d phi - g Phi).
TEST(StatisticalGain, OfAStopIsItsShareOfTime) {
  const SpringLaw law{.stiffness = 0, .cubic = 0, .knees = {{.at = -0.05, .side = -1, .stiffness = 1e5, .cubic = 0}}};
  const double d = 0.03;
  const double share = NormalShareBelow(-0.05 / d);
  const StatisticalGain gain = GainOf(SpringRemainder{law, 0}, {.extension_sd = d, .rate_sd = 1});
  EXPECT_NEAR(gain.by_extension, 1e5 * share, 1e5 * kRounding);
  const double density = std::exp(-0.5 * std::pow(0.05 / d, 2)) / std::sqrt(2 * pi);
  EXPECT_NEAR(gain.mean, -1e5 * (d * density - 0.05 * share), 1e3 * kRounding);
  const StatisticalGain far = GainOf(SpringRemainder{law, 0}, {.extension_sd = 0.005, .rate_sd = 1});
  EXPECT_EQ(far.by_extension, 0);
  EXPECT_EQ(far.mean, 0);
}

TEST(StatisticalGain, OfATyreThatLiftsOff) {
  const LiftoffRemainder tyre{.preload = 3000, .stiffness = 2e5, .damping = 500};
  const PortMotion motion{.mean = -0.002, .extension_sd = 0.012, .rate_sd = 0.6};
  const double mean = 3000 - 400;
  const double deviation = std::hypot(2400, 300);
  const StatisticalGain gain = GainOf(tyre, motion);
  const double off = NormalShareBelow(-mean / deviation);
  EXPECT_NEAR(gain.by_extension, -2e5 * off, 2e5 * kRounding);
  EXPECT_NEAR(gain.by_rate, -500 * off, 500 * kRounding);
  EXPECT_NEAR(gain.mean, NormalMean([&](double z) { return std::max(0.0, -mean - deviation * z); }), 1e-4);
}

TEST(StatisticalGain, LiftingForceHasTheMomentsOfItsDistribution) {
  for (const double mean : {-500.0, 0.0, 800.0, 5000.0}) {
    const LiftingForce force = LiftingForceOf(mean, 1000);
    const double first = NormalMean([&](double z) { return std::max(0.0, mean + 1000 * z); });
    const double second = NormalMean([&](double z) { return std::pow(std::max(0.0, mean + 1000 * z), 2); });
    EXPECT_NEAR(force.mean, first, 1e-4) << mean;
    EXPECT_NEAR(force.deviation, std::sqrt(second - first * first), 1e-3) << mean;
    EXPECT_NEAR(force.off_ground, NormalShareBelow(-mean / 1000), kRounding) << mean;
  }
  EXPECT_EQ(LiftingForceOf(100, 0).mean, 100);
  EXPECT_EQ(LiftingForceOf(-100, 0).off_ground, 1);
}

// Numbers of a tyre under 3 kN, whose motion takes it off the ground now and then.
TEST(StatisticalGain, OfATyreOnItsCurveIsTheAverage) {
  const LoadedTyre law = TyreLaw{.stiffness = 150e3, .progression = 5}.Under(3000);
  const PortMotion motion{.mean = -0.001, .extension_sd = 0.008, .rate_sd = 0.4};
  for (const double damping : {0.0, 500.0}) {
    const TyreRemainder tyre{law, damping, law.Rate(0)};
    // Over the rates first, whose steps leave 1e-8 of the force; then a sum over 4000 extensions, kinked without
    // damping.
    const auto over_rates = [&](double e) { return LiftingForceOf(law.Force(e), damping * motion.rate_sd); };
    double mean = 0;
    double square = 0;
    double slope = 0;
    double off = 0;
    constexpr double kStep = 1e-3;
    for (int k = -8000; k <= 8000; ++k) {
      const double z = kStep * k;
      const double share = kStep * std::exp(-0.5 * z * z) / std::sqrt(2 * pi);
      const LiftingForce force = over_rates(motion.mean + z * motion.extension_sd);
      mean += share * force.mean;
      square += share * (force.mean * force.mean + force.deviation * force.deviation);
      slope += share * force.mean * z / motion.extension_sd;
      off += share * force.off_ground;
    }
    const StatisticalGain gain = GainOf(tyre, motion);
    EXPECT_NEAR(gain.mean + 3000 + tyre.stiffness * motion.mean, mean, 1e-6 * mean);
    EXPECT_NEAR(gain.by_extension + tyre.stiffness, slope, 1e-6 * slope);
    // A step, off the ground without damping, falls between two of the sum's.
    EXPECT_NEAR(gain.by_rate, -damping * off, 1e-5 * damping);
    const LiftingForce force = LiftingForceOf(tyre, motion);
    EXPECT_NEAR(force.deviation, std::sqrt(square - mean * mean), 1e-6 * mean);
    EXPECT_NEAR(force.off_ground, off, 5e-4);
    EXPECT_GT(force.off_ground, 0.01);
  }
}

TEST(StatisticalGain, OfATyreWithoutProgressionIsThatOfItsLiftoff) {
  const LoadedTyre law = TyreLaw{.stiffness = 2e5}.Under(3000);
  const PortMotion motion{.mean = 0.002, .extension_sd = 0.01, .rate_sd = 0.5};
  for (const double damping : {0.0, 300.0}) {
    const StatisticalGain expected = GainOf(LiftoffRemainder{3000, 2e5, damping}, motion);
    const StatisticalGain gain = GainOf(TyreRemainder{law, damping, 2e5}, motion);
    EXPECT_NEAR(gain.mean, expected.mean, 1e-7 * 3000);
    EXPECT_NEAR(gain.by_extension, expected.by_extension, 1e-7 * 2e5);
    EXPECT_NEAR(gain.by_rate, expected.by_rate, 1e-7 * 300);
    EXPECT_EQ(GainOf(TyreRemainder{law, damping, 2e5}, {}).by_extension, 0);
  }
}

}  // namespace
}  // namespace fourpost::statistical_gain_test
