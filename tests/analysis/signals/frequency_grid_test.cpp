#include "analysis/signals/frequency_grid.h"

#include <gmock/gmock.h>

#include "analysis/signals/findings.h"
#include "tests/findings.h"

namespace fourpost {
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
  EXPECT_THAT(Faults("0.5:30:40"), ReportsOption(kFrequencyUnreadable, "--frequencies", {"'0.5'", "'30'", "12 Hz"}));
  EXPECT_THAT(Faults("5rad/s"), Reports(kFrequencyUnreadable));
  EXPECT_THAT(Faults("-1Hz"), Reports(kFrequencyNotPositive, {"'-1Hz'"}));
  EXPECT_THAT(Faults("0Hz"), Reports(kFrequencyNotPositive));
  EXPECT_THAT(Faults("30Hz:1Hz:5"), Reports(kFrequencyRangeFalling));
  EXPECT_THAT(Faults("1Hz:30Hz"), Reports(kFrequencyRangeMalformed));
  EXPECT_THAT(Faults("1Hz:30Hz:1"), Reports(kFrequencyCount, {"2", "10000", "1"}));
  EXPECT_THAT(Faults("1Hz:30Hz:2.5"), Reports(kFrequencyCount, {"2.5"}));
  EXPECT_THAT(Faults("1Hz:2Hz:3Hz"), Reports(kFrequencyStep, {"3 Hz", "1"}));
  EXPECT_THAT(Faults("1Hz,2Hz,1Hz"), Reports(kFrequencyTwice, {"1 Hz"}));
  EXPECT_THAT(Faults(""), Reports(kFrequencyUnreadable));
}

}  // namespace
}  // namespace fourpost
