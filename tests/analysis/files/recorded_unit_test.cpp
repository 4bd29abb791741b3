#include "analysis/files/recorded_unit.h"

#include <numbers>

#include <gtest/gtest.h>

namespace fourpost::recorded_unit_test {
namespace {

TEST(RecordedUnit, IsTakenAsMeasurementSystemsWriteIt) {
  const struct {
    const char* text;
    double si;
    Dimension dimension;
  } cases[] = {{"mm", 1e-3, kLength},
               {"m/s^2", 1, kAcceleration},
               {"m/s2", 1, kAcceleration},
               {"m/s\xC2\xB2", 1, kAcceleration},
               {"m/s\xB2", 1, kAcceleration},  // Latin-1
               {"g", 9.80665, kAcceleration},
               {" kN ", 1000, kForce},
               {"\xC2\xB5m", 1e-6, kLength},
               {"um", 1e-6, kLength},
               {"mm/sec", 1e-3, kVelocity},
               {"\xC2\xB0/s", std::numbers::pi / 180, kFrequency},
               {"in", 0.0254, kLength},
               {"lbf", 4.4482216152605, kForce},
               {"ft/s2", 0.3048, kAcceleration},
               // NIST SP 811, appendix B.8, to its digits where it has fewer.
               {"kip", 4448.2216152605, kForce},
               {"klbf", 4448.2216152605, kForce},
               {"kgf", 9.80665, kForce},
               {"daN", 10, kForce},
               {"lbm", 0.45359237, kMass},
               {"mil", 2.54e-5, kLength},
               {"in/s2", 0.0254, kAcceleration},
               {"ft/s", 0.3048, kVelocity},
               {"mbar", 100, kPressure},
               {"inch", 0.0254, kLength},
               {"Inches", 0.0254, kLength},
               {"inches/sec", 0.0254, kVelocity},
               {"feet", 0.3048, kLength},
               {"Newtons", 1, kForce},
               {"meters/second^2", 1, kAcceleration},
               // NIST SP 811, appendix B.8.
               {"mph", 0.44704, kVelocity},
               {"kph", 1 / 3.6, kVelocity},
               {"km/h", 1 / 3.6, kVelocity},
               {"-", 1, kDimensionless}};
  for (const auto& [text, si, dimension] : cases) {
    const std::optional<Unit> unit = ParseRecordedUnit(text);
    ASSERT_TRUE(unit) << text;
    EXPECT_DOUBLE_EQ(unit->si, si) << text;
    EXPECT_EQ(unit->dimension, dimension) << text;
  }
}

// NIST SP 811, appendix B.8, prints seven digits of these.
TEST(RecordedUnit, OfPressureAndSlugsIsThatOfTheTables) {
  constexpr double kPrinted = 1e-6;
  EXPECT_NEAR(ParseRecordedUnit("psi").value().si / 6894.757, 1, kPrinted);
  EXPECT_NEAR(ParseRecordedUnit("ksi").value().si / 6.894757e6, 1, kPrinted);
  EXPECT_NEAR(ParseRecordedUnit("slug").value().si / 14.59390, 1, kPrinted);
  for (const char* pounds : {"lb", "lbs", "Pounds"}) EXPECT_FALSE(ParseRecordedUnit(pounds)) << pounds;
}

TEST(RecordedUnit, StandsBehindANumber) {
  EXPECT_DOUBLE_EQ(ParseRecordedQuantity("0.02 g").value().si, 0.02 * 9.80665);
  EXPECT_DOUBLE_EQ(ParseRecordedQuantity(" 2e-3in ").value().si, 5.08e-5);
  EXPECT_EQ(ParseRecordedQuantity("5 m/s2").value().unit.dimension, kAcceleration);
  EXPECT_EQ(ParseRecordedQuantity("3").value().si, 3);
  EXPECT_EQ(ParseRecordedQuantity("0.01 1/s").value().si, 0.01);
  for (const char* text : {"", "g", "1 lb", "1 2 mm", "inf m"}) EXPECT_FALSE(ParseRecordedQuantity(text)) << text;
}

TEST(RecordedUnit, IsNothingForWhatIsNone) {
  for (const char* text : {"", "V", "furlong", "m/", "0.5"}) EXPECT_FALSE(ParseRecordedUnit(text)) << text;
}

TEST(ColumnName, IsTakenApart) {
  const struct {
    const char* text;
    const char* name;
    const char* unit;
  } cases[] = {
      {"Force [kN]", "Force", "kN"}, {"Force[kN]", "Force", "kN"},         {"Force (kN)", "Force", "kN"},
      {"Force / kN", "Force", "kN"}, {"Force [V]", "Force", "V"},          {"Force (front)", "Force (front)", ""},
      {"a / b", "a / b", ""},        {"channel[0]", "channel[0]", ""},     {"Force", "Force", ""},
      {"[kN]", "[kN]", ""},          {"x (front) [mm]", "x (front)", "mm"}};
  for (const auto& [text, name, unit] : cases) {
    const NamedColumn column = SplitColumnName(text);
    EXPECT_EQ(column.name, name);
    EXPECT_EQ(column.unit, unit) << text;
  }
}

}  // namespace
}  // namespace fourpost::recorded_unit_test
