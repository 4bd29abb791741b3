#include "analysis/files/rpc/rpc_writer.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/files/byte_writer.h"

namespace fourpost::rpc_writer_test {
namespace {

Recording SineOf(std::size_t samples) {
  Recording recording = {
      .format = "", .description = "", .channels = {{.name = "FL", .unit = "mm"}, {.name = "FR", .unit = "kN"}}};
  for (RecordingChannel& channel : recording.channels) {
    channel.step_s = 1.0 / 204.8;
    for (std::size_t k = 0; k < samples; ++k)
      channel.values.push_back(static_cast<float>(7 * std::sin(0.1 * static_cast<double>(k))));
  }
  return recording;
}

TEST(RpcWriter, RoundTripOfTheSampleIsBitEqual) {
  const Recording sample = OpenGood(SampleRecording("test1.rsp"))->ReadAll();
  const Recording again = ReadBytes(RpcBytes(sample, RpcNumbers::kShortInteger));
  ASSERT_EQ(again.channels.size(), sample.channels.size());
  for (std::size_t i = 0; i < sample.channels.size(); ++i) {
    EXPECT_EQ(again.channels[i].name, sample.channels[i].name);
    EXPECT_EQ(again.channels[i].unit, sample.channels[i].unit);
    EXPECT_EQ(again.channels[i].step_s, sample.channels[i].step_s);
    EXPECT_EQ(again.channels[i].values, sample.channels[i].values);
  }
}

TEST(RpcWriter, RoundTripOfSinglePrecisionIsBitEqual) {
  const Recording sine = SineOf(2 * 512);
  const Recording again = ReadBytes(RpcBytes(sine, RpcNumbers::kFloat));
  EXPECT_EQ(again.channels[1].values, sine.channels[1].values);
  EXPECT_EQ(again.channels[1].step_s, sine.channels[1].step_s);
}

TEST(RpcWriter, RoundsOtherValuesToHalfACount) {
  const Recording sine = SineOf(256);
  const Recording again = ReadBytes(RpcBytes(sine, RpcNumbers::kShortInteger));
  const double count = again.channels[0].count;
  EXPECT_LT(count, 7.0 / 32000);
  for (std::size_t k = 0; k < 256; ++k)
    // Half a count, and the rounding of its own multiplication.
    EXPECT_NEAR(again.channels[0].values[k], sine.channels[0].values[k], 0.5 * count * (1 + 1e-9));
}

TEST(RpcWriter, FillsTheLastFrameWithTheLastValue) {
  const Recording sine = SineOf(300);
  const Recording again = ReadBytes(RpcBytes(sine, RpcNumbers::kFloat));
  ASSERT_EQ(again.channels[0].values.size(), 512);
  EXPECT_EQ(again.channels[0].values[299], sine.channels[0].values[299]);
  EXPECT_EQ(again.channels[0].values[511], sine.channels[0].values[299]);
}

TEST(RpcWriter, RefusesWhatTheFormatCannotHold) {
  EXPECT_THROW(RpcBytes({}, RpcNumbers::kFloat), std::invalid_argument);
  Recording recording = SineOf(256);
  recording.channels[1].values.pop_back();
  EXPECT_THROW(RpcBytes(recording, RpcNumbers::kFloat), std::invalid_argument);
  recording = SineOf(256);
  recording.channels[1].step_s = 1;
  EXPECT_THROW(RpcBytes(recording, RpcNumbers::kFloat), std::invalid_argument);
  recording = SineOf(256);
  recording.channels[0].values[3] = std::nan("");
  EXPECT_THROW(RpcBytes(recording, RpcNumbers::kFloat), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::rpc_writer_test
