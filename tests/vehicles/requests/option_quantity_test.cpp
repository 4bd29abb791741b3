#include "vehicles/requests/option_quantity.h"

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "vehicles/requests/findings.h"

namespace fourpost::option_quantity_test {
namespace {

class OptionQuantity : public testing::Test {
 protected:
  std::optional<double> Read(const std::string& text, const Dimension& dimension,
                             OptionSign sign = OptionSign::kPositive) {
    return ReadQuantity(text, dimension, "--option", diagnostics_, sign);
  }
  std::string Findings() const { return diagnostics_.Format(); }

  Diagnostics diagnostics_;
};

TEST_F(OptionQuantity, IsSiWhateverItsUnit) {
  EXPECT_EQ(Read("5mm", kLength), 0.005);
  EXPECT_EQ(Read("36 km/h", kVelocity), 10);
  EXPECT_EQ(Read("-5mm", kLength, OptionSign::kAny), -0.005);
  EXPECT_EQ(Read("2Hz", kFrequency), 2);
  EXPECT_EQ(Findings(), "");
}

// 1 g is a gram elsewhere.
TEST_F(OptionQuantity, OfAccelerationsMayBeInG) {
  EXPECT_DOUBLE_EQ(Read("0.5g", kAcceleration).value(), 0.5 * 9.80665);
  EXPECT_EQ(Findings(), "");
  EXPECT_FALSE(Read("1g", kLength));
  EXPECT_FALSE(Read("1kg", kAcceleration));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionQuantity, "--option", {"'1kg'", "acceleration", "6 m/s^2 or 0.5 g"}));
}

TEST_F(OptionQuantity, NeedsItsUnitAndItsSign) {
  for (const char* text : {"5", "5N", "five", ""}) EXPECT_FALSE(Read(text, kLength)) << text;
  EXPECT_FALSE(Read("-5mm", kLength));
  EXPECT_FALSE(Read("0mm", kLength));
  EXPECT_FALSE(Read("2rad/s", kFrequency));
  EXPECT_EQ(diagnostics_.items().size(), 7u);
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionQuantity, "--option", {"'5'", "length", "5 mm"}));
  EXPECT_THAT(diagnostics_, ReportsOption(kOptionNotPositive, "--option", {"'0mm'"}));
}

TEST_F(OptionQuantity, OfAShareIsInPercent) {
  EXPECT_DOUBLE_EQ(ReadShare("2%", "--option", diagnostics_).value(), 0.02);
  EXPECT_EQ(ReadShare("100 %", "--option", diagnostics_), 1);
  EXPECT_EQ(Findings(), "");
  for (const char* text : {"1", "0.01", "101%", "-1%", "0%", "1mm"})
    EXPECT_FALSE(ReadShare(text, "--option", diagnostics_)) << text;
  EXPECT_EQ(diagnostics_.items().size(), 6u);
}

TEST_F(OptionQuantity, OfARangeIsTwoFrequencies) {
  const auto range = ReadFrequencyRange("30Hz:0.5Hz", "--option", diagnostics_);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first_Hz, 30);
  EXPECT_EQ(range->last_Hz, 0.5);
  for (const char* text : {"30Hz", "1:2", "1Hz:2", "0Hz:2Hz"})
    EXPECT_FALSE(ReadFrequencyRange(text, "--option", diagnostics_)) << text;
}

}  // namespace
}  // namespace fourpost::option_quantity_test
