#include "analysis/signals/frequency_grid.h"

#include <gmock/gmock.h>

#include "analysis/signals/findings.h"
#include "tests/findings.h"

namespace fourpost::frequency_grid_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

std::vector<double> Parsed(const std::string& text) {
  Diagnostics diagnostics;
  const auto frequencies = ParseFrequencies(text, "--frequencies", diagnostics);
  EXPECT_EQ(diagnostics.Format(), "") << text;
  return frequencies.value_or(std::vector<double>());
}

Diagnostics Faults(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseFrequencies(text, "--frequencies", diagnostics)) << text;
  return diagnostics;
}

TEST(FrequencyGrid, ACountMakesEqualRatios) {
  const double rounding = 1e-12;
  EXPECT_THAT(Parsed("0.5Hz:32 Hz:4"), ElementsAre(0.5, DoubleNear(2, rounding), DoubleNear(8, rounding), 32));
}

TEST(FrequencyGrid, AStepMakesEqualSteps) {
  EXPECT_THAT(Parsed("1Hz:2Hz:0.5Hz"), ElementsAre(1, 1.5, 2));
  EXPECT_THAT(Parsed("1Hz:2Hz:0.4Hz"), ElementsAre(1, 1.4, 1.8));
  // Ten times 0.1 is less than 1 by rounding.
  EXPECT_EQ(Parsed("0.1Hz:1.1Hz:0.1Hz").size(), 11u);
}

TEST(FrequencyGrid, AListIsSorted) { EXPECT_THAT(Parsed("2Hz,1Hz,5Hz"), ElementsAre(1, 2, 5)); }

TEST(FrequencyGrid, TellsEveryFault) {
  EXPECT_THAT(Faults("0.5:30:40"), ReportsOption(kFrequencyUnreadable, "--frequencies", {"'0.5'", "12 Hz"}));
  EXPECT_THAT(Faults("5rad/s"), ReportsOption(kFrequencyUnreadable, "--frequencies"));
  EXPECT_THAT(Faults("-1Hz"), ReportsOption(kFrequencyNotPositive, "--frequencies", {"'-1Hz'"}));
  EXPECT_THAT(Faults("0Hz"), ReportsOption(kFrequencyNotPositive, "--frequencies"));
  EXPECT_THAT(Faults("30Hz:1Hz:5"), ReportsOption(kFrequencyRangeFalling, "--frequencies"));
  EXPECT_THAT(Faults("1Hz:30Hz"), ReportsOption(kFrequencyRangeMalformed, "--frequencies"));
  EXPECT_THAT(Faults("1Hz:30Hz:1"), ReportsOption(kFrequencyCount, "--frequencies", {"2", "10000", "1"}));
  EXPECT_THAT(Faults("1Hz:30Hz:2.5"), ReportsOption(kFrequencyCount, "--frequencies", {"2.5"}));
  EXPECT_THAT(Faults("1Hz:2Hz:3Hz"), ReportsOption(kFrequencyStep, "--frequencies", {"3 Hz", "1"}));
  EXPECT_THAT(Faults("1Hz,2Hz,1Hz"), ReportsOption(kFrequencyTwice, "--frequencies", {"1 Hz"}));
  EXPECT_THAT(Faults(""), ReportsOption(kFrequencyUnreadable, "--frequencies"));
}

}  // namespace
}  // namespace fourpost::frequency_grid_test
