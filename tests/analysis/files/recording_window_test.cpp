#include "analysis/files/recording_window.h"

#include <gmock/gmock.h>

#include "analysis/files/bridged_samples.h"

namespace fourpost::recording_window_test {
namespace {

using testing::ElementsAre;

/// 0, 1, 2 .. at 0.1 s from 1 s on.
TimeRecording Counted(int samples) {
  TimeRecording recording{.start_s = 1, .end_s = 1 + 0.1 * (samples - 1), .step_s = 0.1};
  recording.channels.emplace_back();
  for (int k = 0; k < samples; ++k) recording.channels[0].push_back(k);
  return recording;
}

TEST(RecordingWindow, HasBothEnds) {
  TimeRecording recording = Counted(40);
  ASSERT_TRUE(CutToWindow({.start_s = 1.2, .end_s = 3.5}, recording));
  EXPECT_EQ(recording.samples(), 24);
  EXPECT_EQ(recording.channels[0].front(), 2);
  EXPECT_EQ(recording.channels[0].back(), 25);
  // Of times, by rounding.
  EXPECT_NEAR(recording.start_s, 1.2, 1e-12);
  EXPECT_NEAR(recording.end_s, 3.5, 1e-12);
  EXPECT_THAT(recording.preparations, ElementsAre("cut to 1.2 .. 3.5 s"));
}

TEST(RecordingWindow, BeyondTheRecordingCutsNothing) {
  TimeRecording recording = Counted(4);
  ASSERT_TRUE(CutToWindow({.start_s = 0, .end_s = 99.0}, recording));
  EXPECT_EQ(recording.samples(), 4);
  EXPECT_THAT(recording.preparations, ElementsAre());
}

TEST(RecordingWindow, OfTooFewSamplesIsRefused) {
  TimeRecording recording = Counted(40);
  EXPECT_FALSE(CutToWindow({.start_s = 3.5}, recording));
  EXPECT_FALSE(CutToWindow({.end_s = -1.0}, recording));
  EXPECT_FALSE(CutToWindow({.start_s = 99.0}, recording));
  EXPECT_EQ(recording.samples(), 40);
  EXPECT_TRUE(CutToWindow({.start_s = 3.4}, recording));
  EXPECT_EQ(recording.samples(), kFewestInWindow);
}

TEST(RecordingWindow, KeepsWhatWasMeasuredAtTheEdgeOfAGap) {
  TimeRecording recording = Counted(40);
  recording.gaps = {{{1.2, 1.5}, {4.5, 4.7}}};
  ASSERT_TRUE(CutToWindow({.start_s = 1.2, .end_s = 4.5}, recording));
  const std::vector<char> is_bridged = BridgedSamples(recording, recording.gaps[0]);
  EXPECT_THAT(std::vector<char>(is_bridged.begin(), is_bridged.begin() + 4), ElementsAre(0, 1, 1, 0));
  EXPECT_FALSE(is_bridged.back());
}

TEST(BridgedSamples, LieBetweenMeasuredOnes) {
  const TimeRecording recording = Counted(6);
  EXPECT_THAT(BridgedSamples(recording, {}), ElementsAre());
  EXPECT_THAT(BridgedSamples(recording, {{1.1, 1.4}}), ElementsAre(0, 0, 1, 1, 0, 0));
  // Where the record begins or ends without a measurement, the gap is one step longer than it.
  EXPECT_THAT(BridgedSamples(recording, {{0.9, 1.2}, {1.4, 1.6}}), ElementsAre(1, 1, 0, 0, 0, 1));
}

}  // namespace
}  // namespace fourpost::recording_window_test
