#include "vehicles/requests/parameter_setting.h"

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
  EXPECT_EQ(diagnostics_.Format(), "--set: warning: 'k' = 60 kN/m is outside its bounds 5 kN/m .. 40 kN/m");
}

TEST_F(ParameterSetting, TellsAllFaults) {
  for (const char* text : {"k", "m_sprun=1kg", "k=5", "k=5mm", "k=-5kN/m", "m_sprung=0kg"}) Set(text);
  const std::string faults = diagnostics_.Format();
  for (const char* part :
       {"'k' sets nothing: write name=value", "no parameter 'm_sprun', did you mean 'm_sprung'?",
        "'5' is no value of 'k': give a number in kN/m or the like", "'5mm' is no value of 'k'",
        "'k' = -5 kN/m must be above zero, as the file's value is", "'m_sprung' = 0 kg must be above zero"})
    EXPECT_THAT(faults, HasSubstr(part));
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
  const std::string faults = diagnostics_.Format();
  for (const char* part : {"'k' has no bounds: say how far it shall go, as in k=7.5 kN/m:30 kN/m:13",
                           "no parameter 'kx'", "'1kN/m' is no range: write first:last:how many",
                           "'1kN/m:2kN/m:1' is no range", "'1' is no value of 'kt'", "goes nowhere"})
    EXPECT_THAT(faults, HasSubstr(part));
}

TEST_F(ParameterSetting, RefusesWhatIsGivenTwice) {
  SetParameters({"k=20kN/m", "kt=200kN/m", "k=21kN/m"}, vehicle_, diagnostics_);
  EXPECT_EQ(diagnostics_.Format(), "--set: error: 'k' is given twice");
  diagnostics_ = {};
  EXPECT_EQ(ReadParameterRanges({"k", "kt"}, vehicle_, diagnostics_).size(), 2u);
  EXPECT_EQ(diagnostics_.Format(), "");
  ReadParameterRanges({"k", "k=10kN/m:20kN/m:3"}, vehicle_, diagnostics_);
  EXPECT_EQ(diagnostics_.Format(), "--vary: error: 'k' is given twice");
}

}  // namespace
}  // namespace fourpost
