#include "vehicles/requests/parameter_setting.h"

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/requests/findings.h"

namespace fourpost::parameter_setting_test {
namespace {

using testing::ElementsAre;

class ParameterSetting : public testing::Test {
 protected:
  void Set(const std::string& text) { SetParameter(text, "--set", vehicle_, diagnostics_); }
  auto Range(const std::string& text) { return ReadParameterRange(text, "--vary", vehicle_, diagnostics_); }

  Vehicle vehicle_ = ShippedVehicle("quarter_car");
  Diagnostics diagnostics_;
};

TEST_F(ParameterSetting, GivesAnotherValue) {
  Set("k=20kN/m");
  Set("m_sprung= 0.25 t");
  EXPECT_EQ(ValueOf(vehicle_, "k"), 20e3);
  EXPECT_EQ(ValueOf(vehicle_, "m_sprung"), 250);
  EXPECT_EQ(diagnostics_.Format(), "");
}

TEST_F(ParameterSetting, WarnsOfAValueOutsideItsBounds) {
  Set("k=60 kN/m");
  EXPECT_EQ(ValueOf(vehicle_, "k"), 60e3);
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingOutOfBounds, "--set", {"'k'", "60 kN/m", "5 kN/m", "40 kN/m"}));
  EXPECT_EQ(diagnostics_.items().size(), 1u);
}

TEST_F(ParameterSetting, KeepsTheSignOfItsValueOrOfItsRange) {
  const auto missed = [](double is, double lower, double upper, double value) {
    return MissedSideOfZero({.value = is, .lower = lower, .upper = upper}, value);
  };
  EXPECT_EQ(missed(2, -1, 3, -0.5), "");
  EXPECT_EQ(missed(2, -1, 3, 9), "");
  EXPECT_EQ(missed(2, -1, 3, -9), "above");
  EXPECT_EQ(missed(2, 1, 3, 0), "above");
  EXPECT_EQ(missed(-2, -3, 1, 9), "below");
  EXPECT_EQ(missed(0, -1, 1, 9), "");
  EXPECT_EQ(missed(0, -1, 1, -9), "");
  EXPECT_EQ(missed(0, 0, 1, -9), "above");
  EXPECT_EQ(missed(0, -1, 0, 9), "below");
  vehicle_ = ShippedVehicle("landrover110_model3");
  Set("y_body=-80 mm");
  EXPECT_EQ(ValueOf(vehicle_, "y_body"), -0.08);
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingOutOfBounds, "--set", {"'y_body'"}));
  EXPECT_FALSE(diagnostics_.HasErrors());
}

TEST_F(ParameterSetting, TellsAllFaults) {
  for (const char* text : {"k", "m_sprun=1kg", "k=5", "k=5mm", "k=-5kN/m", "m_sprung=0kg"}) Set(text);
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingIncomplete, "--set", {"'k'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionParameter, "--set", {"'m_sprun'", "'m_sprung'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingUnit, "--set", {"'k=5'", "k=5kN/m"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingUnit, "--set", {"'k=5mm'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingSign, "--set", {"'k'", "-5 kN/m", "above"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingSign, "--set", {"'m_sprung'", "0 kg", "above"}));
  EXPECT_EQ(ValueOf(vehicle_, "m_sprung"), 0);
}

TEST_F(ParameterSetting, ARangeGoesFromBoundToBoundOrAsWritten) {
  const auto bounds = Range("k");
  ASSERT_TRUE(bounds);
  EXPECT_EQ(vehicle_.parameters[bounds->parameter].name, "k");
  EXPECT_EQ(bounds->values.size(), 25u);
  EXPECT_EQ(bounds->values.front(), 5e3);
  EXPECT_EQ(bounds->values.back(), 40e3);
  const auto written = Range("k=30kN/m:10kN/m:3");
  ASSERT_TRUE(written);
  EXPECT_THAT(written->values, ElementsAre(30e3, 20e3, 10e3));
  EXPECT_EQ(diagnostics_.Format(), "");
}

TEST_F(ParameterSetting, TellsTheFaultsOfARange) {
  vehicle_.parameters[2].lower = vehicle_.parameters[2].upper = vehicle_.parameters[2].value;
  for (const char* text : {"k", "kx", "kt=1kN/m", "kt=1kN/m:2kN/m:1", "kt=1:2kN/m:5", "kt=200kN/m:200kN/m:4"})
    EXPECT_FALSE(Range(text)) << text;
  EXPECT_THAT(diagnostics_, ReportsOption(kRangeUnbounded, "--vary", {"'k'", "k=7.5 kN/m:30 kN/m:13"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionParameter, "--vary", {"'kx'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kRangeMalformed, "--vary", {"'1kN/m'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kRangeMalformed, "--vary", {"'1kN/m:2kN/m:1'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kSettingUnit, "--vary", {"'kt=1'"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kRangeEmpty, "--vary", {"'200kN/m:200kN/m:4'"}));
}

TEST_F(ParameterSetting, RefusesWhatIsGivenTwice) {
  SetParameters({"k=20kN/m", "kt=200kN/m", "k=21kN/m"}, vehicle_, diagnostics_);
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionParameterTwice, "--set", {"'k'"}));
  EXPECT_EQ(diagnostics_.items().size(), 1u);
  diagnostics_ = {};
  EXPECT_EQ(ReadParameterRanges({"k", "kt"}, vehicle_, diagnostics_).size(), 2u);
  EXPECT_EQ(diagnostics_.Format(), "");
  ReadParameterRanges({"k", "k=10kN/m:20kN/m:3"}, vehicle_, diagnostics_);
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionParameterTwice, "--vary", {"'k'"}));
  EXPECT_EQ(diagnostics_.items().size(), 1u);
}

}  // namespace
}  // namespace fourpost::parameter_setting_test
