#include "analysis/files/time_recording.h"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "tests/analysis/faults_of.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::time_recording_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;

const std::array<RecordedChannel, 2> kWanted = {
    RecordedChannel{{"x", "displacement"}, kLength, "the extension"},
    RecordedChannel{{"F"}, kForce, "the force"},
};

const char kGood[] =
    "time,F,temperature,displacement\n"
    "s,kN,1,mm\n"
    "1,0.1,20,1\n"
    "1.002,0.2,20,2\n"
    "1.004,0.3,20,3\n"
    "1.006,0.4,20,4\n"
    "1.008,0.5,20,5\n"
    "1.01,0.6,20,6\n";

Diagnostics Faults(const std::string& text) {
  return FaultsOf("bench.csv", text, [](const std::string& file, Diagnostics& diagnostics) {
    return ReadTimeRecording(file, kWanted, diagnostics);
  });
}

TEST(TimeRecording, IsInSiAndInTheOrderWanted) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto recording = ReadTimeRecording(folder.Write("bench.csv", kGood), kWanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_EQ(recording->samples(), 6);
  EXPECT_EQ(recording->start_s, 1);
  // Times near 1 s are rounded to 2e-16 s.
  EXPECT_NEAR(recording->step_s, 0.002, 1e-15);
  EXPECT_NEAR(recording->rate_Hz(), 500, 1e-9);
  EXPECT_EQ(recording->end_s, 1.01);
  EXPECT_THAT(recording->channels[0], ElementsAre(0.001, 0.002, 0.003, 0.004, 0.005, 0.006));
  EXPECT_THAT(recording->channels[1], ElementsAre(100, 200, 300, 400, 500, 600));
}

// Written with a digit too few, steps are 1 and 2 ms, of which neither is the recorder's 1.4 ms.
TEST(TimeRecording, TakesRoundedTimesAsEven) {
  std::string text = "time,F,displacement\ns,N,m\n";
  for (int k = 0; k < 200; ++k)
    text += std::to_string(std::round(1.4 * k) / 1e3) + "," + std::to_string(k) + "," + std::to_string(k) + "\n";
  const TemporaryFolder folder;
  const auto file = folder.Write("rounded.csv", text);
  for (const TimePreparation& preparation : {TimePreparation{}, TimePreparation{.bridge_s = 0.01}}) {
    Diagnostics diagnostics;
    const auto recording = ReadTimeRecording(file, kWanted, diagnostics, kTimeColumn, preparation);
    ASSERT_TRUE(recording) << diagnostics.Format();
    // The last time is rounded by half a millisecond at most, over 199 steps.
    EXPECT_NEAR(recording->step_s, 1.4e-3, 0.5e-3 / 199 + 1e-9);
    EXPECT_TRUE(recording->gaps[0].empty());
  }
}

// Lost samples are gaps, however many they are below a fifth.
TEST(TimeRecording, TakesLostSamplesAsLost) {
  std::string text = "time,F,displacement\ns,N,m\n";
  for (int k = 0; k < 300; ++k)
    if (k % 7 != 3) text += std::to_string(2e-3 * k) + "," + std::to_string(k) + "," + std::to_string(k) + "\n";
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto recording = ReadTimeRecording(folder.Write("lost.csv", text), kWanted, diagnostics, kTimeColumn,
                                           TimePreparation{.bridge_s = 0.01});
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_NEAR(recording->step_s, 2e-3, 1e-12);
  EXPECT_EQ(recording->gaps[0].size(), 43);
}

// A cubic through noise would go on by metres.
TEST(TimeRecording, HoldsTheEndValuesOfAChannelThatBeginsLate) {
  std::string text = "time,F,displacement\ns,N,mm\n";
  for (int k = 0; k < 300; ++k)
    text += std::to_string(2e-3 * k) + "," + std::to_string(std::sin(k)) + "," +
            (k < 15 ? "" : std::to_string(10 + std::cos(5 * k))) + "\n";
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto recording = ReadTimeRecording(folder.Write("late.csv", text), kWanted, diagnostics, kTimeColumn,
                                           TimePreparation{.bridge_s = 0.05});
  ASSERT_TRUE(recording) << diagnostics.Format();
  for (std::size_t k = 0; k < 15; ++k) EXPECT_NEAR(recording->channels[0][k], recording->channels[0][15], 1e-15) << k;
  // Of both channels one gap.
  EXPECT_THAT(recording->preparations, testing::Contains(testing::StartsWith("1 gap bridged")));
}

TEST(TimeRecording, BridgesWhatWasHeldBesideOtherGaps) {
  std::string text = "time,F,displacement\ns,N,mm\n";
  for (int k = 0; k < 300; ++k) {
    const int at = k >= 150 && k < 200 ? 149 : k;
    text += std::to_string(2e-3 * k) + "," + (k == 200 ? "" : std::to_string(std::sin(0.1 * at))) + "," +
            std::to_string(10 + std::cos(0.07 * at)) + "\n";
  }
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto recording = ReadTimeRecording(folder.Write("held.csv", text), kWanted, diagnostics, kTimeColumn,
                                           TimePreparation{.bridge_s = 0.01});
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_THAT(diagnostics, Reports(kChannelHeld, 153, {"'x'"}));
  EXPECT_THAT(recording->preparations, testing::Contains(testing::StartsWith("1 gap bridged")));
}

TEST(TimeRecording, TakesUnitSignScaleAndDelayFromTheStudy) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  std::ostringstream text;
  text.precision(12);
  text << "time,x,F\ns,V,N\n";
  const double w = 2 * std::numbers::pi * 5;
  for (int k = 0; k < 400; ++k) text << 0.002 * k << ',' << std::sin(w * 0.002 * k) << ',' << k << '\n';
  const std::array<RecordedChannel, 2> wanted = {
      RecordedChannel{
          .names = {"x"}, .dimension = kLength, .what = "the extension", .unit = "mm", .factor = -3, .delay_s = 0.0031},
      RecordedChannel{{"F"}, kForce, "the force"}};
  const auto recording = ReadTimeRecording(folder.Write("r.csv", text.str()), wanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  // Two samples at the end are not known.
  ASSERT_EQ(recording->samples(), 398u);
  EXPECT_NEAR(recording->end_s, 0.794, 1e-12);
  EXPECT_EQ(recording->channels[1].front(), 0);
  EXPECT_EQ(recording->channels[1].back(), 397);
  for (std::size_t k = 0; k < recording->samples(); ++k)
    // The spline errs by 1e-7 of the amplitude, see UniformSpline, more next to the ends.
    EXPECT_NEAR(recording->channels[0][k], -3e-3 * std::sin(w * (0.002 * static_cast<double>(k) + 0.0031)), 1e-8) << k;
}

TEST(TimeRecording, CutsTheStartWhereAChannelIsEarly) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::array<RecordedChannel, 2> wanted = {
      RecordedChannel{{"displacement"}, kLength, "the extension"},
      RecordedChannel{.names = {"F"}, .dimension = kForce, .what = "the force", .delay_s = -0.002}};
  const auto recording = ReadTimeRecording(folder.Write("bench.csv", kGood), wanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_NEAR(recording->start_s, 1.002, 1e-12);
  EXPECT_THAT(recording->channels[0], ElementsAre(0.002, 0.003, 0.004, 0.005, 0.006));
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(recording->channels[1][k], 100.0 * (1 + static_cast<double>(k)), 1e-9);
}

TEST(TimeRecordingFault, DelaysLongerThanTheRecord) {
  std::array<RecordedChannel, 2> wanted = kWanted;
  wanted[0].delay_s = 0.006;
  EXPECT_THAT(FaultsOf("bench.csv", kGood,
                       [&](const std::string& file, Diagnostics& diagnostics) {
                         return ReadTimeRecording(file, wanted, diagnostics);
                       }),
              ReportsOnly(kShorterThanDelays, 0));
}

TEST(TimeRecordingFault, ColumnsAreMissing) {
  EXPECT_THAT(Faults(Replace(Replace(kGood, "displacement", "y"), "time", "tame")),
              AllOf(Reports(kChannelColumnMissing, 1, {"'x'"}), Reports(kChannelColumnMissing, {"'time'", "'tame'"})));
}

TEST(TimeRecordingFault, UnitOfAnotherDimension) {
  EXPECT_THAT(Faults(Replace(kGood, "kN", "mm/s")), ReportsOnly(kUnitOfOtherDimension, 2, {"'F'", "'mm/s'", "'N'"}));
}

TEST(TimeRecordingFault, NoRowOfUnits) {
  EXPECT_THAT(Faults(Replace(kGood, "s,kN,1,mm\n", "")),
              AllOf(Reports(kUnitMissing, 1, {"'time'", "'s'", "'time [s]'"}),
                    Reports(kUnitMissing, 1, {"{channel: F, unit: N}"})));
}

TEST(TimeRecordingFault, FieldsThatAreNoNumbers) {
  EXPECT_THAT(Faults(Replace(Replace(kGood, "0.2", "nan"), "20,4", "20,")),
              AllOf(Reports(kSampleMissing, 4, {"'F'", "'nan'"}), Reports(kSampleMissing, 6, {"'displacement'"})));
}

TEST(TimeRecordingFault, Gap) {
  EXPECT_THAT(Faults(Replace(kGood, "1.006,0.4,20,4\n", "")),
              ReportsOnly(kTimeStepUneven, 6, {"1.004 s", "1.008 s", "0.002 s"}));
}

// Longer than the record itself: still one fault.
TEST(TimeRecordingFault, LongGap) {
  EXPECT_THAT(Faults(Replace(Replace(kGood, "1.008", "7.008"), "1.01,", "7.01,")),
              ReportsOnly(kTimeStepUneven, 7, {"1.006 s", "7.008 s", "0.002 s"}));
}

TEST(TimeRecordingFault, TimeStepsBack) {
  EXPECT_THAT(Faults(Replace(kGood, "1.006", "0.006")), Reports(kTimeStepUneven, {"1.004 s", "0.006 s"}));
}

TEST(TimeRecordingFault, TimeAndDisplacementAreSwapped) {
  EXPECT_THAT(Faults("time,F,x\ns,N,m\n0,1,1\n1,5,1.01\n0,2,1.02\n-1,1,1.03\n0,0,1.04\n1,4,1.05\n"),
              Reports(kTimeStepsBack, {"'x'"}));
  EXPECT_THAT(Faults(Replace(Replace(kGood, "s,kN", "mm,kN"), "1,mm", "1,s")),
              Reports(kTimeSwapped, {"'displacement'"}));
}

TEST(TimeRecordingFault, TimeStandsStill) {
  EXPECT_THAT(Faults("time,F,x\ns,N,m\n1,1,1\n1,2,2\n1,3,3\n1,4,4\n1,5,5\n"), Reports(kTimeDoesNotRise));
  EXPECT_THAT(Faults("time,F,x\ns,N,m\n1,1,1\n1,2,2\n1,3,3\n1,4,4\n2,5,5\n2,5,6\n2,5,7\n3,5,7\n"),
              Reports(kTimeTooCoarse, {"8 samples in 2 s, about 4 samples a second"}));
}

// Each step is within a quarter of the usual one.
TEST(TimeRecordingFault, RateChangesOnTheWay) {
  std::ostringstream text;
  text << "time,F,x\ns,N,m\n";
  for (int k = 0; k < 50; ++k) text << 0.002 * k << ",1,1\n";
  for (int k = 0; k < 50; ++k) text << 0.1 + 0.0025 * k << ",1,1\n";
  EXPECT_THAT(Faults(text.str()), ReportsOnly(kTimeDrifts, 53, {"-0.012373737 s", "0.002247475 s"}));
}

TEST(TimeRecordingFault, TooShort) {
  EXPECT_THAT(Faults("time,F,x\ns,N,m\n0,1,1\n1,2,2\n2,3,3\n"), ReportsOnly(kTooFewSamples, 0, {"3"}));
}

TEST(TimeRecordingFault, AllAreToldAtOnce) {
  const std::string text = Replace(Replace(Replace(kGood, "kN", "K"), "1.006,0.4,20,4\n", ""), "0.2", "lost");
  EXPECT_THAT(Faults(text), AllOf(Reports(kUnitOfOtherDimension, {"'K'"}), Reports(kSampleMissing, {"'lost'"}),
                                  Reports(kTimeStepUneven, {"1.004 s", "1.008 s"})));
}

}  // namespace
}  // namespace fourpost::time_recording_test
