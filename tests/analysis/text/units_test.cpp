#include "analysis/text/units.h"

#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace fourpost::units_test {
namespace {

TEST(Units, ReadsASingleUnit) {
  const std::optional<Unit> unit = ParseUnit("kN");
  ASSERT_TRUE(unit);
  EXPECT_EQ(unit->si, 1000);
  EXPECT_EQ(unit->dimension, kForce);
}

TEST(Units, ReadsAProductOfPowers) {
  const std::optional<Unit> unit = ParseUnit("kg*m^2");
  ASSERT_TRUE(unit);
  EXPECT_EQ(unit->si, 1);
  EXPECT_EQ(unit->dimension, kInertia);
}

TEST(Units, DividesByWhatFollowsASlash) {
  const std::optional<Unit> stiffness = ParseUnit("N/mm");
  ASSERT_TRUE(stiffness);
  EXPECT_EQ(stiffness->si, 1000);
  EXPECT_EQ(stiffness->dimension, kStiffness);
  const std::optional<Unit> damping = ParseUnit("kN*s/m");
  ASSERT_TRUE(damping);
  EXPECT_EQ(damping->si, 1000);
  EXPECT_EQ(damping->dimension, kDamping);
  // From left to right: only the unit after the slash is below it.
  EXPECT_EQ(ParseUnit("N/m*s")->dimension, kDamping);
}

TEST(Units, ReadsNegativePowers) {
  EXPECT_EQ(ParseUnit("s^-2")->dimension, (Dimension{0, 0, -2}));
  EXPECT_EQ(ParseUnit("1/s")->dimension, kFrequency);
  EXPECT_EQ(ParseUnit("mm^-1")->si, 1000);
}

TEST(Units, AnglesAndPercentagesArePureNumbers) {
  EXPECT_EQ(ParseUnit("deg")->si, std::numbers::pi / 180);
  EXPECT_EQ(ParseUnit("deg")->dimension, kDimensionless);
  EXPECT_EQ(ParseUnit("%")->si, 0.01);
}

TEST(Units, ReadsSpeedsPerHour) {
  EXPECT_EQ(ParseUnit("km/h")->dimension, kVelocity);
  EXPECT_DOUBLE_EQ(ParseQuantity("36 km/h")->si, 10);
  EXPECT_DOUBLE_EQ(ParseQuantity("2min")->si, 120);
}

// NIST SP 811, appendix B.9: 1 lbf/in = 175.1268 N/m.
TEST(Units, MayBeThoseOfTheUnitedStates) {
  EXPECT_NEAR(ParseUnit("lbf/in").value().si / 175.1268, 1, 1e-6);
  EXPECT_EQ(ParseUnit("lbf/in")->dimension, kStiffness);
  EXPECT_EQ(ParseUnit("lbf*s/in")->dimension, kDamping);
  EXPECT_DOUBLE_EQ(ParseQuantity("2 in")->si, 0.0508);
  EXPECT_EQ(FormatQuantity(ParseQuantity("120.5 lbf/in")->si, "lbf/in"), "120.5 lbf/in");
}

TEST(Units, AreUnknownWhenAnyPartIs) {
  for (const char* text : {"", "furlong", "N/", "/s", "N//m", "N m", "m^", "m^0", "m^10", "m^x", "kn", "m^2^2", " m"})
    EXPECT_FALSE(ParseUnit(text)) << text;
}

TEST(Units, AreUnknownBeyondADouble) { EXPECT_FALSE(ParseUnit("MPa^9*MPa^9*MPa^9*MPa^9*MPa^9*MPa^9")); }

TEST(Units, AreLikelyByTheSizeOfTheNumber) {
  EXPECT_EQ(LikelyUnit(kLength, 30), "mm");
  EXPECT_EQ(LikelyUnit(kLength, -30), "mm");
  EXPECT_EQ(LikelyUnit(kLength, 0.3), "m");
  EXPECT_EQ(LikelyUnit(kStiffness, 32), "N/mm");
  EXPECT_EQ(LikelyUnit(kStiffness, 32000), "N/m");
  EXPECT_EQ(LikelyUnit(kDamping, 1.5), "kN*s/m");
  EXPECT_EQ(LikelyUnit(kDamping, 1500), "N*s/m");
  EXPECT_EQ(LikelyUnit(kMass, 30), "kg");
}

// What is suggested must be legal.
TEST(Units, ThatAreLikelyHaveTheDimension) {
  for (const Dimension& dimension : {kLength, kVelocity, kStiffness, kDamping, kCubicStiffness, kPressure, kArea,
                                     kVolume, kDensity, kMass, kForce, kTorque, kDimensionless})
    for (const double number : {1e-3, 1e6})
      EXPECT_EQ(ParseUnit(LikelyUnit(dimension, number)).value().dimension, dimension) << LikelyUnit(dimension, number);
}

TEST(Quantity, HasANumberAndAUnit) {
  const std::optional<Quantity> quantity = ParseQuantity(" 32 N/mm ");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->si, 32000);
  EXPECT_EQ(quantity->unit.dimension, kStiffness);
  EXPECT_EQ(quantity->unit_text, "N/mm");
}

TEST(Quantity, NeedsNoBlankBeforeItsUnit) { EXPECT_EQ(ParseQuantity("32N/mm")->si, 32000); }

TEST(Quantity, MayBePerUnit) {
  for (const char* text : {"3/m", "3 /m", "3 1/m"}) {
    const std::optional<Quantity> quantity = ParseQuantity(text);
    ASSERT_TRUE(quantity) << text;
    EXPECT_EQ(quantity->si, 3);
    EXPECT_EQ(quantity->unit.dimension, kPerLength);
    EXPECT_EQ(quantity->unit_text, "1/m");
  }
  EXPECT_FALSE(ParseQuantity("3/"));
}

TEST(Quantity, IsAPureNumberWithoutAUnit) {
  const std::optional<Quantity> quantity = ParseQuantity("-0.3");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->si, -0.3);
  EXPECT_EQ(quantity->unit.dimension, kDimensionless);
  EXPECT_EQ(quantity->unit_text, "");
}

TEST(Quantity, OfADecimalUnitIsRoundedOnce) {
  // 1.3 * 0.001 is another double.
  EXPECT_EQ(ParseQuantity("1.3 mm")->si, 0.0013);
  EXPECT_NE(1.3 * 0.001, 0.0013);
  EXPECT_EQ(ParseQuantity("0.7 kN/m")->si, 700);
}

TEST(Quantity, MustBeFiniteAndWhole) {
  for (const char* text : {"", "N", "nan", "inf", "1e400", "1e308 kN", "3 4", "3 furlong", "3 N m", "1,5 mm", "--3"})
    EXPECT_FALSE(ParseQuantity(text)) << text;
}

TEST(Quantity, MayHaveAnExponent) { EXPECT_EQ(ParseQuantity("2.5e-3 m")->si, 0.0025); }

TEST(SiUnit, IsTheUsualOneOrComposed) {
  EXPECT_EQ(SiUnit(kStiffness), "N/m");
  EXPECT_EQ(SiUnit(kDimensionless), "1");
  EXPECT_EQ(SiUnit({2, 0, -3}), "kg^2/s^3");
  EXPECT_EQ(SiUnit({0, -1, -3}), "1/m/s^3");
}

TEST(SiUnit, ReadsBackAsItsDimension) {
  for (int kilogram = -2; kilogram <= 2; ++kilogram)
    for (int metre = -3; metre <= 3; ++metre)
      for (int second = -3; second <= 3; ++second) {
        const Dimension dimension{kilogram, metre, second};
        const std::optional<Unit> unit = ParseUnit(SiUnit(dimension));
        ASSERT_TRUE(unit) << SiUnit(dimension);
        EXPECT_EQ(unit->dimension, dimension) << SiUnit(dimension);
        EXPECT_EQ(unit->si, 1) << SiUnit(dimension);
      }
}

TEST(DimensionName, IsAWordWhereThereIsOne) {
  EXPECT_EQ(DimensionName(kStiffness), "stiffness");
  EXPECT_EQ(DimensionName({2, 0, 0}), "kg^2");
}

TEST(FormatQuantity, TakesTheFewestDigits) {
  EXPECT_EQ(FormatQuantity(31420, "N/mm"), "31.42 N/mm");
  EXPECT_EQ(FormatQuantity(0.0011, "mm"), "1.1 mm");
  EXPECT_EQ(FormatQuantity(std::numbers::pi / 6, "deg"), "30 deg");
}

TEST(FormatQuantity, ShowsNoUnitForAPureNumber) {
  EXPECT_EQ(FormatQuantity(0.3, ""), "0.3");
  EXPECT_EQ(FormatQuantity(0.3, "1"), "0.3");
}

TEST(FormatQuantity, ReadsBackToTheSameDouble) {
  for (const char* unit : {"N/mm", "kN*s/m", "mm", "t", "bar", "%"})
    for (const double si : {1.0 / 3, 1e-7 / 3, 123456.789, -2e11 / 7, 0.1 + 0.2})
      EXPECT_EQ(ParseQuantity(FormatQuantity(si, unit))->si, si) << FormatQuantity(si, unit);
}

TEST(FormatQuantity, InDegreesIsAtMostOneRoundingAway) {
  for (const double si : {1.0 / 3, 0.1, 2.7, 1e-5 / 7})
    EXPECT_DOUBLE_EQ(ParseQuantity(FormatQuantity(si, "deg"))->si, si);
}

TEST(FormatQuantity, RefusesAnUnknownUnit) { EXPECT_THROW(FormatQuantity(1, "furlong"), std::invalid_argument); }

}  // namespace
}  // namespace fourpost::units_test
