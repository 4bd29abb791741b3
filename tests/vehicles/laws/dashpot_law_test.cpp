#include "vehicles/laws/dashpot_law.h"

#include <algorithm>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::dashpot_law_test {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

struct NamedLaw {
  std::string name;
  DashpotLaw law;
};

class RandomLaws {
 public:
  explicit RandomLaws(unsigned seed) : engine_(seed) {}

  /// One increasing law of each kind, with and without friction.
  std::vector<NamedLaw> Next() {
    const double compression = Rate();
    // The smooth law needs a moderate ratio.
    const double rebound = compression * Between(0.1, 10);
    std::vector<NamedLaw> laws = {
        {"linear", {compression, compression}},
        {"bilinear", {compression, rebound}},
        {"smooth", DashpotLaw::Smooth(compression, rebound, Between(0.01, 0.5))},
        {"digressive", DashpotLaw::Digressive(compression, rebound, RandomKnee(), RandomKnee())},
        {"table", RandomTable()},
    };
    for (std::size_t i = laws.size(); i-- > 0;)
      laws.push_back({laws[i].name + " with friction", laws[i].law.WithFriction(Between(1, 300), Between(1e-3, 0.02))});
    return laws;
  }

  double Speed() { return Sign() * std::pow(10, Between(-6, 1)); }

 private:
  double Between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double Sign() { return Between(-1, 1) < 0 ? -1 : 1; }
  double Rate() { return std::pow(10, Between(2, 4)); }
  DashpotLaw::Knee RandomKnee() { return {Between(0.02, 0.5), Rate()}; }

  DashpotLaw RandomTable() {
    std::vector<double> speed = {-Between(0.1, 1), 0, Between(0.01, 0.5)};
    std::vector<double> force = {Rate() * speed.front(), 0, Rate() * speed.back()};
    for (int i = 0; i < 5; ++i) {
      const double step = Between(0.01, 0.3);
      speed.push_back(speed.back() + step);
      force.push_back(force.back() + Rate() * step);
    }
    return DashpotLaw::Table(speed, force);
  }

  std::mt19937_64 engine_;
};

TEST(DashpotLaw, IsNoForceByDefault) {
  EXPECT_EQ(DashpotLaw().Force(3), 0);
  EXPECT_EQ(DashpotLaw().Force(-3), 0);
  EXPECT_EQ(DashpotLaw().MeanRate(), 0);
}

// Of one evaluation, and of the same numbers to the last bit.
TEST(DashpotLaw, ForceAndSlopeAreForceAndSlope) {
  RandomLaws random(11);
  for (int i = 0; i < 200; ++i) {
    for (const auto& [name, law] : random.Next()) {
      for (const double v : {random.Speed(), 0.0}) {
        const auto [force, slope] = law.ForceAndSlope(v);
        EXPECT_EQ(force, law.Force(v)) << name << " at " << v;
        EXPECT_EQ(slope, law.Slope(v)) << name << " at " << v;
      }
    }
  }
}

TEST(DashpotLaw, BilinearHasARateForEachSide) {
  const DashpotLaw law = {1500, 2600};
  EXPECT_EQ(law.Force(2), 5200);
  EXPECT_EQ(law.Force(-2), -3000);
  EXPECT_EQ(law.Slope(0.1), 2600);
  EXPECT_EQ(law.Slope(-0.1), 1500);
  EXPECT_EQ(law.Slope(0), 2050);
  EXPECT_EQ(law.Velocity(5200), 2);
  EXPECT_EQ(law.Velocity(-3000), -2);
  EXPECT_EQ(law.LeastRate(), 1500);
  EXPECT_EQ(law.GreatestRate(), 2600);
  EXPECT_EQ(law.MeanRate(), 2050);
}

TEST(DashpotLaw, SaturatingHasHalfOfItsStraightForceAtItsSpeed) {
  const DashpotLaw law = DashpotLaw::Saturating(1500, 2600, 0.5, 0.25);
  EXPECT_EQ(law.Force(0.25), 0.5 * 2600 * 0.25);
  EXPECT_EQ(law.Force(-0.5), -0.5 * 1500 * 0.5);
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_EQ(law.Slope(0), 2050);
  EXPECT_EQ(law.Slope(0.25), 650);
  EXPECT_EQ(law.Slope(-0.5), 375);
  EXPECT_EQ(law.GreatestRate(), 2600);
  EXPECT_EQ(law.LeastRate(), 0);
  // Its limit is rate times speed, of which 1 / (1 + v / speed) is missing.
  EXPECT_NEAR(law.Force(1e9), 650, 650 * 0.25e-9 + 650 * kUlp);
  EXPECT_NEAR(law.Velocity(law.Force(0.7)), 0.7, 64 * kUlp);
  EXPECT_NEAR(law.Velocity(law.Force(-0.7)), -0.7, 64 * kUlp);
  EXPECT_TRUE(std::isinf(law.Velocity(650)));
  ASSERT_EQ(law.Kinks().size(), 1U);
  EXPECT_EQ(law.Kinks()[0].jump, 1100);
}

// Of v = V sin, with a = V / speed: c / pi times the integral of sin^2 / (1 + a sin) over half a cycle, twice; that is
// 2/a - pi/a^2 + (pi - 2 asin a) / (a^2 sqrt(1 - a^2)).
TEST(DashpotLaw, SaturatingHasTheEquivalentRateOfItsClosedForm) {
  const DashpotLaw law = DashpotLaw::Saturating(2000, 2000, 0.4, 0.4);
  for (const double a : {0.1, 0.5, 0.9}) {
    constexpr int kSamples = 20000;
    double work = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double sine = std::sin(2 * std::numbers::pi * (k + 0.5) / kSamples);
      work += law.Force(0.4 * a * sine) * sine / kSamples;
    }
    const double half_cycle =
        2 / a - std::numbers::pi / (a * a) + (std::numbers::pi - 2 * std::asin(a)) / (a * a * std::sqrt(1 - a * a));
    // The midpoint rule errs by corners of the third derivative at rest: below 1 / kSamples^2 of the force.
    EXPECT_NEAR(2 * work / (0.4 * a), 2 / std::numbers::pi * 2000 * half_cycle, 2000 * 10.0 / kSamples / kSamples);
  }
}

/// 100 x mean squared error over variance of the best linear dashpot, for a sinusoidal rate.
double ErrorOfTheMeanRate(const DashpotLaw& law) {
  constexpr int kSamples = 10000;
  double error = 0;
  double sum = 0;
  double square = 0;
  for (int k = 0; k < kSamples; ++k) {
    const double v = std::sin(2 * std::numbers::pi * (k + 0.5) / kSamples);
    error += std::pow(law.Force(v) - law.MeanRate() * v, 2);
    sum += law.Force(v);
    square += law.Force(v) * law.Force(v);
  }
  return 100 * error / (square - sum * sum / kSamples);
}

// With mean m and half difference d of the rates: 100 (d^2/2) / ((m^2 + d^2)/2 - 4 d^2/pi^2).
TEST(DashpotLaw, LinearLawMissesNineteenPercentOfABilinearOneAsInTheThesis) {
  EXPECT_NEAR(ErrorOfTheMeanRate({1000, 2600}), 19.04, 0.005);
  EXPECT_NEAR(ErrorOfTheMeanRate({1000, 2500}), 17.75, 0.005);
}

TEST(DashpotLaw, SmoothIsItsFormula) {
  const DashpotLaw law = DashpotLaw::Smooth(1000, 3000, 0.1);
  EXPECT_DOUBLE_EQ(law.Force(0.2), (2000 + 1000 * std::tanh(2.0)) * 0.2);
  EXPECT_DOUBLE_EQ(law.Force(-0.2), -(2000 - 1000 * std::tanh(2.0)) * 0.2);
  EXPECT_EQ(law.Slope(0), 2000);
  // f(V) - f(-V) has no part of the odd function.
  EXPECT_NEAR(law.MeanRate(), 2000, 8 * kUlp * 2000);
}

TEST(DashpotLaw, SmoothTendsToBilinear) {
  const DashpotLaw bilinear(1000, 3000);
  const DashpotLaw smooth = DashpotLaw::Smooth(1000, 3000, 1e-6);
  // tanh differs from 1 by less than rounding beyond 19 times its speed.
  for (const double v : {-3.0, -0.1, -2e-5, 2e-5, 0.02, 1.0})
    EXPECT_NEAR(smooth.Force(v), bilinear.Force(v), 4 * kUlp * 3000 * std::abs(v));
}

TEST(DashpotLaw, SmoothSlopeBoundsAreReachedAndNeverPassed) {
  for (const DashpotLaw& law : {DashpotLaw::Smooth(1000, 3000, 0.1), DashpotLaw::Smooth(4000, 700, 0.1)}) {
    double least = kInfinity;
    double greatest = 0;
    // The extremes lie at 1.2 times the speed; half the grid's step from them the slope differs by a part in 1e9.
    for (double v = -0.3; v < 0.3; v += 1e-5) {
      least = std::min(least, law.Slope(v));
      greatest = std::max(greatest, law.Slope(v));
    }
    EXPECT_GE(least, law.LeastRate() * (1 - 8 * kUlp));
    EXPECT_NEAR(least, law.LeastRate(), 1e-8 * greatest);
    EXPECT_LE(greatest, law.GreatestRate() * (1 + 8 * kUlp));
    EXPECT_NEAR(greatest, law.GreatestRate(), 1e-8 * greatest);
  }
}

// (1.19968 + 1) / (1.19968 - 1).
TEST(DashpotLaw, SmoothIncreasesBelowARatioOfEleven) {
  EXPECT_GT(DashpotLaw::Smooth(100, 1101, 0.1).LeastRate(), 0);
  EXPECT_LT(DashpotLaw::Smooth(100, 1102, 0.1).LeastRate(), 0);
}

TEST(DashpotLaw, DigressiveChangesRateAtEachKnee) {
  const DashpotLaw law = DashpotLaw::Digressive(1000, 3000, {0.2, 400}, {0.1, 500});
  EXPECT_DOUBLE_EQ(law.Force(0.05), 150);
  EXPECT_DOUBLE_EQ(law.Force(0.1), 300);
  EXPECT_DOUBLE_EQ(law.Force(0.3), 300 + 0.2 * 500);
  EXPECT_DOUBLE_EQ(law.Force(-0.2), -200);
  EXPECT_DOUBLE_EQ(law.Force(-0.5), -200 - 0.3 * 400);
  EXPECT_EQ(law.Slope(0), 2000);
  EXPECT_EQ(law.Slope(0.1), 1750);
  EXPECT_EQ(law.Slope(-0.2), 700);
  EXPECT_EQ(law.LeastRate(), 400);
  EXPECT_EQ(law.GreatestRate(), 3000);
  EXPECT_DOUBLE_EQ(law.MeanRate(), 2000);
}

TEST(DashpotLaw, DigressiveWithoutChangeOfRateIsBilinear) {
  const DashpotLaw bilinear(1000, 3000);
  const DashpotLaw digressive = DashpotLaw::Digressive(1000, 3000, {0.2, 1000}, {0.1, 3000});
  for (const double v : {-2.0, -0.2, -0.03, 0.0, 0.03, 0.1, 2.0}) {
    EXPECT_NEAR(digressive.Force(v), bilinear.Force(v), 4 * kUlp * 3000 * std::abs(v));
    EXPECT_EQ(digressive.Slope(v), bilinear.Slope(v));
  }
}

TEST(DashpotLaw, TableReproducesSamplesOfABilinearLaw) {
  const DashpotLaw bilinear(1000, 3000);
  std::vector<double> speed;
  std::vector<double> force;
  for (int i = -10; i <= 10; ++i) {
    speed.push_back(0.05 * i);
    force.push_back(bilinear.Force(speed.back()));
  }
  const DashpotLaw table = DashpotLaw::Table(speed, force);
  for (std::size_t i = 0; i < speed.size(); ++i) EXPECT_NEAR(table.Force(speed[i]), force[i], 4 * kUlp * 3000);
  // Away from the kink and beyond the ends the points are on a line.
  for (const double v : {-0.9, -0.333, -0.111, 0.111, 0.333, 0.9})
    EXPECT_NEAR(table.Force(v), bilinear.Force(v), 16 * kUlp * 3000);
}

TEST(DashpotLaw, TableImpliesTheOrigin) {
  const DashpotLaw table = DashpotLaw::Table({0.1, 0.3}, {200, 400});
  EXPECT_EQ(table.Force(0), 0);
  EXPECT_EQ(table.Force(0.3), 400);
  EXPECT_LT(table.Force(-0.1), 0);
  const DashpotLaw same = DashpotLaw::Table({0, 0.1, 0.3}, {0, 200, 400});
  for (double v = -0.5; v < 0.5; v += 0.07) EXPECT_EQ(table.Force(v), same.Force(v));
}

TEST(DashpotLaw, FrictionAddsItsForce) {
  const DashpotLaw law = DashpotLaw(1000, 3000).WithFriction(50, 0.01);
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_DOUBLE_EQ(law.Force(0.01), 30 + 50 * std::tanh(1.0));
  EXPECT_DOUBLE_EQ(law.Force(-2), -2050);
  EXPECT_DOUBLE_EQ(law.Slope(0), 2000 + 5000);
  EXPECT_EQ(law.LeastRate(), 1000);
  EXPECT_DOUBLE_EQ(law.GreatestRate(), 3000 + 5000);
  EXPECT_EQ(law.MeanRate(), 2000);
  EXPECT_EQ(law.WithFriction(20, 0.01).Force(-2), -2020);
  EXPECT_EQ(law.WithFriction(0, 0.01).Force(-2), -2000);
}

TEST(DashpotLaw, FrictionAloneHasAVelocityBelowItsForce) {
  const DashpotLaw law = DashpotLaw().WithFriction(50, 0.01);
  EXPECT_DOUBLE_EQ(law.Velocity(25), 0.01 * std::atanh(0.5));
  EXPECT_DOUBLE_EQ(law.Velocity(-25), -0.01 * std::atanh(0.5));
  EXPECT_EQ(law.Velocity(0), 0);
}

TEST(DashpotLaw, VelocityIsTheInverse) {
  RandomLaws random(1);
  for (int k = 0; k < 100; ++k)
    for (const auto& [name, law] : random.Next())
      for (int i = 0; i < 100; ++i) {
        const double v = random.Speed();
        const double force = law.Force(v);
        // Rounding of the force, seen through the slope.
        EXPECT_NEAR(law.Velocity(force), v, 16 * kUlp * (std::abs(v) + std::abs(force) / law.LeastRate())) << name;
      }
}

TEST(DashpotLaw, VelocityOfNoForceIsZero) {
  RandomLaws random(2);
  for (const auto& [name, law] : random.Next()) EXPECT_EQ(law.Velocity(0), 0) << name;
}

TEST(DashpotLaw, SlopeIsTheDerivative) {
  RandomLaws random(3);
  constexpr double kStep = 1e-7;
  for (int k = 0; k < 100; ++k)
    for (const auto& [name, law] : random.Next())
      for (int i = 0; i < 20; ++i) {
        const double v = random.Speed();
        if (std::abs(v) <= kStep) continue;
        // Truncation (step / friction speed)^2 = 1e-8 of the friction's slope; rounding of the force over the step.
        const double tolerance = 1e-8 * law.GreatestRate() + 4 * kUlp * std::abs(law.Force(v)) / kStep;
        EXPECT_NEAR((law.Force(v + kStep) - law.Force(v - kStep)) / (2 * kStep), law.Slope(v), tolerance) << name;
      }
}

TEST(DashpotLaw, SlopeStaysWithinItsBounds) {
  RandomLaws random(4);
  for (int k = 0; k < 100; ++k)
    for (const auto& [name, law] : random.Next())
      for (int i = 0; i < 100; ++i) {
        const double slope = law.Slope(random.Speed());
        const double rounding = 100 * kUlp * law.GreatestRate();
        EXPECT_GE(slope, law.LeastRate() - rounding) << name;
        EXPECT_LE(slope, law.GreatestRate() + rounding) << name;
      }
}

TEST(DashpotLaw, IsNanForNan) {
  RandomLaws random(5);
  for (const auto& [name, law] : random.Next()) {
    EXPECT_TRUE(std::isnan(law.Force(kNan))) << name;
    EXPECT_TRUE(std::isnan(law.Slope(kNan))) << name;
    EXPECT_TRUE(std::isnan(law.Velocity(kNan))) << name;
  }
}

TEST(DashpotLaw, HasNoFiniteVelocityForAForceItCannotCarry) {
  EXPECT_EQ(DashpotLaw().Velocity(5), kInfinity);
  EXPECT_EQ(DashpotLaw(1000, 0).Velocity(5), kInfinity);
  EXPECT_EQ(DashpotLaw::Smooth(1000, 0, 0.1).Velocity(5), kInfinity);
  EXPECT_EQ(DashpotLaw::Digressive(1000, 1000, {0.1, 0}, {0.1, 0}).Velocity(-101), -kInfinity);
  EXPECT_EQ(DashpotLaw().WithFriction(50, 0.01).Velocity(51), kInfinity);
  // A cubic through (0, 0), (0.1, 50), (0.2, 50) has no slope left at its end.
  EXPECT_EQ(DashpotLaw::Table({0.1, 0.2}, {50, 50}).Velocity(51), kInfinity);
}

template <typename Make>
void ExpectRefused(Make make, const std::string& message) {
  EXPECT_THAT(make, ThrowsMessage<std::invalid_argument>(StrEq(message)));
}

TEST(DashpotLaw, RefusesRatesAndSpeedsThatAreNone) {
  ExpectRefused([] { DashpotLaw(-1, 2); }, "DashpotLaw: bump = -1, must be finite and not negative");
  ExpectRefused([] { DashpotLaw(1, kNan); }, "DashpotLaw: rebound = nan, must be finite and not negative");
  ExpectRefused([] { DashpotLaw::Smooth(1, 2, 0); }, "DashpotLaw: speed = 0, must be finite and positive");
  ExpectRefused(
      [] {
        DashpotLaw::Digressive(1, 2, {0, 1}, {1, 1});
      },
      "DashpotLaw: bump_knee.speed = 0, must be finite and positive");
  ExpectRefused(
      [] {
        DashpotLaw::Digressive(1, 2, {1, 1}, {1, -1});
      },
      "DashpotLaw: rebound_knee.rate = -1, must be finite and not negative");
  ExpectRefused([] { DashpotLaw(1, 2).WithFriction(-1, 1); },
                "DashpotLaw: friction force = -1, must be finite and not negative");
  ExpectRefused([] { DashpotLaw(1, 2).WithFriction(1, 0); },
                "DashpotLaw: friction speed = 0, must be finite and positive");
}

TEST(DashpotLaw, RefusesTablesThatAreNoLaw) {
  ExpectRefused(
      [] {
        DashpotLaw::Table({0.1, 0.2}, {1});
      },
      "DashpotLaw: force: needs a value for each of 2 speeds, has 1");
  ExpectRefused([] { DashpotLaw::Table({}, {}); }, "DashpotLaw: speed: number of points = 1, must be at least 2");
  ExpectRefused([] { DashpotLaw::Table({0, 0.2}, {1, 2}); }, "DashpotLaw: force = 1, must be 0 at speed 0");
  ExpectRefused(
      [] {
        DashpotLaw::Table({0.2, 0.1}, {1, 2});
      },
      "DashpotLaw: speed = 0.1, must be above the one before, 0.2");
  ExpectRefused(
      [] {
        DashpotLaw::Table({-0.1, 0.1}, {1, 2});
      },
      "DashpotLaw: force = 0, must be not below the one before, 1");
}

}  // namespace
}  // namespace fourpost::dashpot_law_test
