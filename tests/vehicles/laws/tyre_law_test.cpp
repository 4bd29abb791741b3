#include "vehicles/laws/tyre_law.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::tyre_law_test {
namespace {

TyreLaw Progressive() { return {.stiffness = 180e3, .progression = 4}; }

/// As measured, from an arbitrary zero: force begins at 5 mm.
TyreLaw Measured() {
  TyreLaw law;
  law.curve.emplace(std::vector<double>{0.005, 0.01, 0.02, 0.03, 0.04}, std::vector<double>{0, 800, 2700, 4900, 7300});
  return law;
}

TEST(TyreLaw, IsItsPolynomialOnTheGroundAndStraightOffIt) {
  const TyreLaw law = Progressive();
  EXPECT_DOUBLE_EQ(law.Force(0.02), 180e3 * 0.02 * (1 + 4 * 0.02));
  EXPECT_DOUBLE_EQ(law.Slope(0.02), 180e3 * (1 + 8 * 0.02));
  EXPECT_DOUBLE_EQ(law.Force(-0.02), -180e3 * 0.02);
  EXPECT_DOUBLE_EQ(law.Slope(-0.02), 180e3);
  EXPECT_FALSE(law.IsLinear());
  EXPECT_TRUE(TyreLaw{.stiffness = 180e3}.IsLinear());
}

TEST(TyreLaw, StiffensWithTheRootOfTheLoad) {
  for (const double load : {0.0, 500.0, 4000.0, 9000.0}) {
    const LoadedTyre tyre = Progressive().Under(load);
    const double rate = std::sqrt(180e3 * 180e3 + 4 * 180e3 * 4 * load);
    EXPECT_NEAR(tyre.Rate(0), rate, 1e-14 * rate);
    // The closed form of its deflection.
    EXPECT_NEAR(tyre.place, (rate - 180e3) / (2 * 180e3 * 4), 1e-15);
  }
}

TEST(TyreLaw, DeflectionsCarryTheirLoads) {
  for (const TyreLaw& law : {Progressive(), Measured(), TyreLaw{.stiffness = 180e3}})
    // On and beyond the curve, and where only a tyre that is held would be.
    for (const double load : {-300.0, 0.0, 10.0, 2000.0, 4100.0, 9000.0})
      EXPECT_NEAR(law.Force(law.Deflection(load)), load, 1e-12 * 9000);  // rounding
}

TEST(TyreLaw, SlopeAndEnergyAreThoseOfTheForce) {
  constexpr double kStep = 1e-6;
  for (const TyreLaw& law : {Progressive(), Measured()})
    for (const double d : {-0.013, 0.0071, 0.018, 0.0331, 0.052}) {
      // Truncation by the third derivative of a piece of a cubic, 1e-12 of 1e9 N/m^3; rounding 1e-12 N over 1e-6 m.
      EXPECT_NEAR(law.Slope(d), (law.Force(d + kStep) - law.Force(d - kStep)) / (2 * kStep), 1e-9 * 300e3 + 5e-3);
      EXPECT_NEAR(law.Force(d), (law.Energy(d + kStep) - law.Energy(d - kStep)) / (2 * kStep), 1e-4);
    }
  EXPECT_EQ(Progressive().Energy(0), 0);
}

TEST(LoadedTyre, HasItsLoadAtRestAndNoneWhereItLiftsOff) {
  for (const TyreLaw& law : {Progressive(), Measured(), TyreLaw{.stiffness = 180e3}}) {
    const LoadedTyre tyre = law.Under(3500);
    EXPECT_EQ(tyre.Force(0), 3500);
    EXPECT_NEAR(tyre.Force(tyre.Liftoff()), 0, 1e-11);
    EXPECT_LT(tyre.Liftoff(), 0);
    EXPECT_EQ(tyre.Energy(0), 0);
    // From rest to lift-off it gives back what its load had stored.
    EXPECT_NEAR(tyre.Energy(tyre.Liftoff()), law.Energy(law.Deflection(0)) - law.Energy(law.Deflection(3500)), 1e-11);
  }
}

// A constant rate needs no place: a tyre without a rate carries its load all the same.
TEST(LoadedTyre, OfAConstantRateStandsAtZero) {
  EXPECT_EQ((TyreLaw{.stiffness = 180e3}.Under(3500).place), 0);
  EXPECT_EQ(TyreLaw().Under(3500).Force(0.01), 3500);
}

}  // namespace
}  // namespace fourpost::tyre_law_test
