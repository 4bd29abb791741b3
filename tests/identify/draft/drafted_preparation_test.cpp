#include "identify/draft/drafted_preparation.h"

#include <gtest/gtest.h>

namespace fourpost::drafted_preparation_test {
namespace {

DraftedPreparation WithNoise(const SensorNoise& of_axle, const SensorNoise& of_body) {
  DraftedPreparation preparation;
  preparation.summary.rest = RestTime{1, 2.5};
  preparation.summary.columns = {{.name = "Axle", .unit = "mm", .unit_known = true, .noise = of_axle},
                                 {.name = "Body", .unit = "mm", .unit_known = true, .noise = of_body}};
  return preparation;
}

std::string LinesOf(const DraftedPreparation& preparation) {
  std::vector<ChannelMatch> matches;
  for (const char* const name : {"Axle", "Body"})
    matches.push_back({.name = name, .source = {.channels = {SourceChannel(name)}}, .correlation = {}, .rival = {}});
  return NoiseLines(preparation, matches);
}

const SensorNoise kHum = {.sd = 0.05, .is_white = false, .below_Hz = 60, .line_Hz = 50.7};

TEST(DraftedPreparation, SaysHumOnce) {
  EXPECT_EQ(LinesOf(WithNoise(kHum, kHum)),
            "    noise:  # standard deviations at rest, from 1.00 to 2.50 s after the first sample; hum of 50 Hz\n"
            "      Axle: 0.05 mm\n"
            "      Body: 0.05 mm\n");
}

TEST(DraftedPreparation, HumTooWeakForALineIsNoMotion) {
  SensorNoise weak = {.sd = 0.05, .is_white = false, .below_Hz = 400};
  EXPECT_NE(LinesOf(WithNoise(kHum, weak)).find("Body: 0.05 mm\n"), std::string::npos);
  weak.below_Hz = 20;
  EXPECT_NE(LinesOf(WithNoise(kHum, weak)).find("Body: 0.05 mm  # look at: not white"), std::string::npos);
}

TEST(DraftedPreparation, NoiseThatIsNoHumIsToBeLookedAt) {
  SensorNoise other = kHum;
  for (const std::optional<double> line_Hz : {std::optional<double>(), std::optional(57.0)}) {
    other.line_Hz = line_Hz;
    EXPECT_EQ(LinesOf(WithNoise({.sd = 0.05}, other)),
              "    noise:  # standard deviations at rest, from 1.00 to 2.50 s after the first sample\n"
              "      Axle: 0.05 mm\n"
              "      Body: 0.05 mm  # look at: not white, was the vehicle at rest?\n");
  }
  // The third harmonic of 60 Hz.
  other.line_Hz = 180;
  EXPECT_NE(LinesOf(WithNoise({.sd = 0.05}, other)).find("; hum of 60 Hz\n"), std::string::npos);
}

}  // namespace
}  // namespace fourpost::drafted_preparation_test
