#include "analysis/signals/frequency_grid.h"

#include <gmock/gmock.h>

namespace fourpost {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> Parsed(const std::string& text) {
  Diagnostics diagnostics;
  const auto frequencies = ParseFrequencies(text, "--frequencies", diagnostics);
  EXPECT_EQ(diagnostics.Format(), "") << text;
  return frequencies.value_or(std::vector<double>());
}

std::string Faults(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseFrequencies(text, "--frequencies", diagnostics)) << text;
  return diagnostics.Format();
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
  EXPECT_THAT(Faults("0.5:30:40"), HasSubstr("--frequencies: error: '0.5' is no frequency: write a number with its "
                                             "unit, such as 12 Hz\n--frequencies: error: '30' is no"));
  EXPECT_THAT(Faults("5rad/s"), HasSubstr("is no frequency"));
  EXPECT_THAT(Faults("-1Hz"), HasSubstr("'-1Hz' is no frequency above zero"));
  EXPECT_THAT(Faults("0Hz"), HasSubstr("above zero"));
  EXPECT_THAT(Faults("30Hz:1Hz:5"), HasSubstr("does not rise; `--direction down`"));
  EXPECT_THAT(Faults("1Hz:30Hz"), HasSubstr("is no range"));
  EXPECT_THAT(Faults("1Hz:30Hz:1"), HasSubstr("from 2 to 10000, not 1"));
  EXPECT_THAT(Faults("1Hz:30Hz:2.5"), HasSubstr("not 2.5"));
  EXPECT_THAT(Faults("1Hz:2Hz:3Hz"), HasSubstr("steps of 3 Hz make 1 frequencies"));
  EXPECT_THAT(Faults("1Hz,2Hz,1Hz"), HasSubstr("1 Hz stands twice"));
  EXPECT_THAT(Faults(""), HasSubstr("is no frequency"));
}

}  // namespace
}  // namespace fourpost
