#include "identify/experiments/four_post/worst_octave.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::worst_octave_test {
namespace {

using Frequencies = std::vector<double>;

/// Without a floor every deviation is a share of the response.
const ModelError kError{.gain_dB = 1, .floor = 0};
const FrequencyBand kBand{0.5, 16};

MeasuredRun MeasuredAt(const std::string& name, const Frequencies& frequency_Hz) {
  const std::size_t count = frequency_Hz.size();
  MeasuredRun run{.name = name,
                  .excitation = {.frequency_Hz = frequency_Hz, .amplitude_m = Frequencies(count, 0.01), .shape = {1}},
                  .channels = {}};
  run.channels.push_back({.name = "s",
                          .unit = "m",
                          .response = std::vector<std::complex<double>>(count, 1),
                          .radial_sd = Frequencies(count),
                          .tangential_sd = Frequencies(count)});
  return run;
}

/// A model whose gain is too large by this share at each frequency.
FrequencyResponse Off(const std::vector<double>& shares) {
  FrequencyResponse modelled;
  modelled.channels.push_back({.name = "s", .unit = "m", .response = {}});
  for (const double share : shares) modelled.channels[0].response.emplace_back(1 + share);
  return modelled;
}

WorstOctave WorstOf(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                    const FrequencyBand& band = kBand) {
  return WorstOctaveOf("s", runs, modelled, kError, band).value_or(WorstOctave{.recording = "none"});
}

TEST(WorstOctave, IsWhereTheRootMeanSquareIsLargest) {
  // Sums of squares are 0.05 over five frequencies and 0.03 over three.
  const WorstOctave worst = WorstOf({MeasuredAt("heave", {1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3})},
                                    {Off({0.1, 0.1, 0.1, 0.1, 0.1, 0.11, 0.11, 0.11})});
  EXPECT_EQ(worst.recording, "heave");
  EXPECT_EQ(worst.lower_Hz, 2);
  EXPECT_EQ(worst.upper_Hz, 4);
  // One dB is 12.2 %; gain is one of two residuals at a frequency.
  EXPECT_NEAR(worst.misfit, 0.11 / (std::pow(10, 0.05) - 1) / std::sqrt(2), 1e-3);
}

TEST(WorstOctave, HasAFrequencyOnTheBorderAboveWhateverItsLastDigit) {
  // In the lower octave it would be the worst of four.
  const WorstOctave worst =
      WorstOf({MeasuredAt("heave", {1, 1.2, 1.5, 2 * (1 - 1e-9), 2.5, 3})}, {Off({0.1, 0.1, 0.1, 0.9, 0.1, 0.1})});
  EXPECT_EQ(worst.lower_Hz, 2);
}

TEST(WorstOctave, HasTheLastFrequencyOfTheBandBelow) {
  const WorstOctave worst =
      WorstOf({MeasuredAt("heave", {2, 2.5, 3, 4.5, 6, 8})}, {Off({0.1, 0.1, 0.1, 0.1, 0.1, 0.9})}, {2, 8});
  EXPECT_EQ(worst.lower_Hz, 4);
  EXPECT_EQ(worst.upper_Hz, 8);
}

TEST(WorstOctave, IsCutAtTheBand) {
  const WorstOctave low = WorstOf({MeasuredAt("heave", {0.7, 0.8, 0.9})}, {Off({0.1, 0.1, 0.1})}, {0.6, 0.95});
  EXPECT_EQ(low.lower_Hz, 0.6);
  EXPECT_EQ(low.upper_Hz, 0.95);
}

TEST(WorstOctave, HasFewerThanThreeFrequenciesOnlyWhereNoOtherHasMore) {
  EXPECT_EQ(WorstOf({MeasuredAt("heave", {1, 1.5, 2, 2.5, 3})}, {Off({0.9, 0.9, 0.1, 0.1, 0.1})}).lower_Hz, 2);
  // Whatever comes first.
  EXPECT_EQ(WorstOf({MeasuredAt("heave", {1, 1.3, 1.6, 2, 2.5})}, {Off({0.1, 0.1, 0.1, 0.9, 0.9})}).lower_Hz, 1);
  EXPECT_EQ(WorstOf({MeasuredAt("heave", {1, 1.5, 2, 2.5})}, {Off({0.9, 0.9, 0.1, 0.1})}).lower_Hz, 1);
}

TEST(WorstOctave, IsThatOfTheWorstRecording) {
  const Frequencies few = {1, 1.3, 1.6};
  const std::vector<MeasuredRun> runs = {MeasuredAt("heave", few), MeasuredAt("pitch", few),
                                         MeasuredAt("roll", {1, 1.5})};
  // The last has too few frequencies to count.
  EXPECT_EQ(WorstOf(runs, {Off({0.1, 0.1, 0.1}), Off({0.2, 0.2, 0.2}), Off({0.9, 0.9})}).recording, "pitch");
  EXPECT_EQ(WorstOf(runs, {Off({0.3, 0.3, 0.3}), Off({0.2, 0.2, 0.2}), Off({0.9, 0.9})}).recording, "heave");
}

TEST(WorstOctave, IsNoneWithoutAResidual) {
  EXPECT_FALSE(WorstOctaveOf("other", {MeasuredAt("heave", {1, 2, 3})}, {Off({1, 1, 1})}, kError, kBand));
  EXPECT_FALSE(WorstOctaveOf("s", {MeasuredAt("heave", {1, 2, 3})}, {Off({NAN, NAN, NAN})}, kError, kBand));
}

}  // namespace
}  // namespace fourpost::worst_octave_test
