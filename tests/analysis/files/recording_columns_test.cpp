#include "analysis/files/recording_columns.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording/memory_recording.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/rpc/rpc_writer.h"
#include "analysis/files/time_recording.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::recording_columns_test {
namespace {

using ::testing::ElementsAre;

RecordingColumns ColumnsOf(std::vector<RecordingChannel> channels, Diagnostics& diagnostics) {
  return {std::make_shared<MemoryRecording>(Recording{"", "", std::move(channels)}), "r", diagnostics};
}

RecordingChannel Sine(const std::string& name, double rate_Hz, double start_s, std::size_t samples) {
  RecordingChannel channel = {.name = name, .unit = "mm", .start_s = start_s, .step_s = 1 / rate_Hz};
  for (std::size_t k = 0; k < samples; ++k)
    channel.values.push_back(std::sin(2 * std::numbers::pi * (start_s + static_cast<double>(k) / rate_Hz)));
  return channel;
}

TEST(RecordingColumns, OfOneRateAreTheSamplesThemselves) {
  Diagnostics diagnostics;
  const RecordingColumns columns = ColumnsOf({Sine("a", 100, 0.5, 50), Sine("b", 100, 0.5, 50)}, diagnostics);
  EXPECT_THAT(diagnostics.items(), testing::IsEmpty());
  EXPECT_THAT(columns.names(), ElementsAre("time", "a", "b"));
  EXPECT_THAT(columns.units(), ElementsAre("s", "mm", "mm"));
  EXPECT_EQ(columns.rows(2), 50);
  EXPECT_EQ(columns.Column(0)[3], 0.5 + 3 * (1 / 100.0));
  EXPECT_EQ(columns.Column(1), Sine("a", 100, 0.5, 50).values);
  EXPECT_FALSE(columns.HasSeveralRates());
}

TEST(RecordingColumns, OfSeveralRatesAreInterpolatedToTheFastestWithAWarning) {
  Diagnostics diagnostics;
  const RecordingColumns columns =
      ColumnsOf({Sine("slow", 50, 0, 101), Sine("fast", 200, 0.25, 301), Sine("later", 200, 0.5, 301)}, diagnostics);
  EXPECT_THAT(diagnostics, ReportsOnly(kChannelsInterpolated, 0, {"slow, later", "200 Hz", "10 Hz"}));
  // From the latest start to the earliest end.
  EXPECT_DOUBLE_EQ(columns.Column(0).front(), 0.5);
  EXPECT_NEAR(columns.Column(0).back(), 1.75, 1e-12);
  EXPECT_EQ(columns.rate_Hz(1), 50);
  EXPECT_EQ(columns.Recorded(1).size(), 101);
  const std::vector<double> slow = columns.Column(1);
  const std::vector<double> times = columns.Column(0);
  // 50 samples a period: (2 pi / 50)^4 / 384, see UniformSpline; all columns agree with the sine of their times.
  for (std::size_t k = 0; k < slow.size(); ++k) EXPECT_NEAR(slow[k], std::sin(2 * std::numbers::pi * times[k]), 1e-6);
  const std::vector<double> later = columns.Column(3);
  // Samples of one rate stay as they are.
  EXPECT_EQ(later.front(), Sine("later", 200, 0.5, 1).values.front());
}

TEST(RecordingColumns, OfTimesOfTheirOwnAreInterpolatedAlongStraightLines) {
  Diagnostics diagnostics;
  const RecordingChannel jittered = {.name = "j", .unit = "N", .values = {0, 1, 3}, .times_s = {0, 0.1, 0.3}};
  const RecordingColumns columns = ColumnsOf({jittered, Sine("a", 20, 0, 7)}, diagnostics);
  ASSERT_EQ(columns.rows(0), 7);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(columns.Column(1)[k], 0.5 * static_cast<double>(k), 1e-12);
}

TEST(RecordingColumns, WithoutTimesAreTheChannels) {
  Diagnostics diagnostics;
  const RecordingColumns columns = ColumnsOf(
      {{.name = "Time", .unit = "s", .values = {0, 1}}, {.name = "F", .unit = "N", .values = {5, 6, 7}}}, diagnostics);
  EXPECT_THAT(columns.names(), ElementsAre("Time", "F"));
  EXPECT_EQ(columns.rows(1), 3);
}

TEST(RecordingColumns, ChannelsWithoutTimesAreLeftOutBesideOthers) {
  Diagnostics diagnostics;
  const RecordingColumns columns =
      ColumnsOf({Sine("a", 100, 0, 5), {.name = "note", .unit = "", .values = {1}}}, diagnostics);
  EXPECT_THAT(diagnostics, ReportsOnly(kChannelsWithoutTimes, 0, {"note"}));
  EXPECT_THAT(columns.names(), ElementsAre("time", "a"));
}

TEST(RecordingColumns, ThatNeverRanTogetherAreRefused) {
  Diagnostics diagnostics;
  ColumnsOf({Sine("a", 100, 0, 50), Sine("b", 200, 10, 50)}, diagnostics);
  EXPECT_THAT(diagnostics, Reports(kNoCommonTime, 0, {"'b'", "10 s"}));
}

TEST(RecordedTableOfRecordings, ReadsASampleOfRpcAsAnyTable) {
  const TemporaryFolder folder;
  // Its name says nothing.
  const std::filesystem::path file = folder.Write("run.csv", ReadText(SampleRecording("test1.rsp")));
  Diagnostics diagnostics;
  const std::vector<RecordedChannel> wanted = {{.names = {"ACC_76zGlob"}, .dimension = kAcceleration, .what = "a"},
                                               {.names = {"D_23magLo"}, .dimension = kLength, .what = "z"}};
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_EQ(recording->samples(), 2048);
  // By its times: rounding of their sum.
  EXPECT_NEAR(recording->step_s, 0.004, 1e-15);
  EXPECT_EQ(recording->channels[1][0], 1e-3 * OpenGood(file)->Values(4)[0]);
}

TEST(RecordedTableOfRecordings, HasTimeStampsInSecondsAfterTheFirst) {
  const TemporaryFolder folder;
  const std::filesystem::path file =
      folder.Write("r.csv",
                   "Timestamp,F [N]\n2025-11-14 23:59:59.500,1\n2025-11-14 23:59:59.750,2\n2025-11-15 "
                   "00:00:00.000,3\n2025-11-15 00:00:00.250,4\n");
  Diagnostics diagnostics;
  const std::vector<RecordedChannel> wanted = {{.names = {"F"}, .dimension = kForce, .what = "a force"}};
  const std::optional<TimeRecording> recording = ReadTimeRecording(file, wanted, diagnostics);
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_EQ(recording->start_s, 0);
  EXPECT_EQ(recording->step_s, 0.25);
}

TEST(RecordedTableOfRecordings, HasATimeColumnPerChannel) {
  const TemporaryFolder folder;
  const std::filesystem::path file =
      folder.Write("r.csv", "Time,F,Time,z\nms,N,ms,mm\n0,1,0,10\n100,2,200,30\n200,3,400,50\n300,4,,\n400,5,,\n");
  Diagnostics diagnostics;
  const std::optional<RecordedTable> table = ReadRecordedTable(file, diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_THAT(diagnostics, ReportsOnly(kChannelsInterpolated, 0, {"z"}));
  EXPECT_THAT(table->names(), ElementsAre("time", "F", "z"));
  for (std::size_t row = 0; row < 5; ++row)
    EXPECT_NEAR(table->Number(row, 2).value(), 10.0 + 10.0 * static_cast<double>(row), 1e-12);
}

TEST(RecordedTableOfRecordings, SummaryIsOfTheSamplesAsRecorded) {
  Diagnostics diagnostics;
  const RecordedTable table("r", ColumnsOf({Sine("slow", 50, 0, 101), Sine("fast", 200, 0.25, 301)}, diagnostics));
  const RecordingSummary summary = Summarise(table);
  ASSERT_EQ(summary.columns.size(), 2);
  EXPECT_EQ(summary.columns[0].samples, 101);
  EXPECT_EQ(summary.columns[0].rate_Hz, 50);
  ASSERT_TRUE(summary.time);
  EXPECT_NEAR(summary.time->rate_Hz, 200, 1e-9);
}

}  // namespace
}  // namespace fourpost::recording_columns_test
