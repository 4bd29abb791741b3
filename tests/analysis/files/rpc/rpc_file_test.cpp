#include "analysis/files/rpc/rpc_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/recording/findings.h"
#include "analysis/files/rpc/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::rpc_file_test {
namespace {

using ::testing::ElementsAre;

using Keys = std::vector<std::pair<std::string, std::string>>;

std::string HeaderOf(const Keys& keys) {
  std::string header;
  for (const auto& [key, value] : keys) header += Padded(key, 32) + Padded(value, 96);
  return Padded(header, 512 * ((header.size() + 511) / 512));
}

/// Two channels, frames of 4 and groups of 8 points, three frames: the last group is half padding.
Keys KeysOf(const std::string& format, const std::string& type = "SHORT_INTEGER") {
  return {
      {"FORMAT", format},     {"NUM_HEADER_BLOCKS", "4"}, {"NUM_PARAMS", "15"},     {"FILE_TYPE", "TIME_HISTORY"},
      {"DATA_TYPE", type},    {"TIME_TYPE", "RESPONSE"},  {"DELTA_T", "2.0E-03"},   {"PTS_PER_FRAME", "4"},
      {"PTS_PER_GROUP", "8"}, {"CHANNELS", "2"},          {"FRAMES", "3"},          {"DESC.CHAN_1", "\"left post\""},
      {"UNITS.CHAN_1", "mm"}, {"SCALE.CHAN_1", "0.5"},    {"SCALE.CHAN_2", "-0.25"}};
}

Keys With(Keys keys, const std::string& key, const std::string& value) {
  for (auto& [name, text] : keys)
    if (name == key) text = value;
  return keys;
}

/// 0, 1, 2, ... of the first channel, 100, 101, ... of the second.
template <typename Number>
std::vector<Number> Groups() {
  std::vector<Number> numbers;
  for (int group = 0; group < 2; ++group)
    for (int channel = 0; channel < 2; ++channel)
      for (int k = 8 * group; k < 8 * group + 8; ++k)
        numbers.push_back(static_cast<Number>(k < 12 ? 100 * channel + k : -1));
  return numbers;
}

void ExpectCounting(const Recording& recording, double first, double second) {
  ASSERT_EQ(recording.channels.size(), 2);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_EQ(recording.channels[0].values.at(k), first * static_cast<double>(k));
    EXPECT_EQ(recording.channels[1].values.at(k), second * static_cast<double>(100 + k));
  }
  EXPECT_EQ(recording.channels[0].values.size(), 12);
}

TEST(RpcFile, SampleOfOthersReadsAsAnIndependentReaderReadsIt) {
  const Recording recording = OpenGood(SampleRecording("test1.rsp"))->ReadAll();
  ASSERT_EQ(recording.channels.size(), 5);
  EXPECT_EQ(recording.format, "RPC III");
  EXPECT_EQ(recording.channels[4].name, "D_23magLo");
  EXPECT_EQ(recording.channels[4].unit, "mm");
  EXPECT_EQ(recording.channels[4].step_s, 0.004);
  EXPECT_EQ(recording.channels[4].samples, 2048);
  // By Python's struct: short integers from byte 9216 on, times SCALE.CHAN_n.
  const std::array<const char*, 5> digests = {"f1d62a831361b50971c62dd13e2f8939335a0a06ba75e2fe14b7390b5829a2ab",
                                              "5957cbf9022ad39aaea1c419a6230eeb31107712fb6297c3c64d61c002fb8996",
                                              "260c7cae148726bcbfbcede805182f856073d826d8009d6ae0ccdb404eabf020",
                                              "b58d62c96ad312443db8fc7a7a52ef98f049af5b80603aef4f4a7662fd510ba7",
                                              "b02d334f4a1a7001a136d7ea3cb94936c45fc55d2e588cf0ce35edc575ec8b50"};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(DigestOf(recording.channels[i].values), digests[i]);
  // What nCode wrote of the first channel before it rounded to counts: within two of them.
  EXPECT_NEAR(*std::max_element(recording.channels[0].values.begin(), recording.channels[0].values.end()), 241.96741,
              2 * recording.channels[0].count);
}

TEST(RpcFile, IsReadInEveryFormatAndDataType) {
  for (const bool big : {false, true}) {
    const std::string format = big ? "BINARY_IEEE_BIG_END" : "BINARY_IEEE_LITTLE_END";
    ExpectCounting(ReadBytes(HeaderOf(KeysOf(format)) + BytesOf(Groups<std::int16_t>(), big)), 0.5, -0.25);
    ExpectCounting(ReadBytes(HeaderOf(KeysOf(format, "FLOATING_POINT")) + BytesOf(Groups<float>(), big)), 1, 1);
  }
  ExpectCounting(ReadBytes(HeaderOf(KeysOf("BINARY")) + BytesOf(Groups<std::int16_t>())), 0.5, -0.25);
  std::string text;
  for (const int number : Groups<int>()) text += std::to_string(number) + (text.size() % 60 > 50 ? "\r\n" : "  ");
  ExpectCounting(ReadBytes(HeaderOf(KeysOf("ASCII")) + text), 0.5, -0.25);
}

TEST(RpcFile, ChannelHasItsNameUnitAndTimes) {
  const Recording recording = ReadBytes(HeaderOf(KeysOf("BINARY")) + BytesOf(Groups<std::int16_t>()));
  EXPECT_EQ(recording.channels[0].name, "left post");
  EXPECT_EQ(recording.channels[0].unit, "mm");
  EXPECT_EQ(recording.channels[1].name, "channel 2");
  EXPECT_EQ(recording.channels[0].step_s, 0.002);
}

TEST(RpcFile, HalfFramesHoldNoData) {
  Keys keys = KeysOf("BINARY");
  keys.emplace_back("HALF_FRAMES", "1");
  // Points 0 and 1 and the last two are the half frames, which leaves 2 to 13.
  std::vector<std::int16_t> numbers;
  for (int group = 0; group < 2; ++group)
    for (int channel = 0; channel < 2; ++channel)
      for (int k = 0; k < 8; ++k) numbers.push_back(static_cast<std::int16_t>(100 * channel + 8 * group + k - 2));
  ExpectCounting(ReadBytes(HeaderOf(keys) + BytesOf(numbers)), 0.5, -0.25);
}

class RpcFault : public ::testing::Test {
 protected:
  static Diagnostics Faults(const std::string& key, const std::string& value) {
    return FaultsOfBytes(HeaderOf(With(KeysOf("BINARY"), key, value)) + BytesOf(Groups<std::int16_t>()));
  }
};

TEST_F(RpcFault, CutShort) {
  const std::string whole = HeaderOf(KeysOf("BINARY")) + BytesOf(Groups<std::int16_t>());
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, whole.size() - 1)),
              ReportsOnly(kRecordingCutShort, 0, {"RPC III", "byte 2048", "64", "2111"}));
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, 1000)), ReportsOnly(kRecordingCutShort, 0, {"header"}));
}

TEST_F(RpcFault, NumbersThatTheFileCannotHold) {
  for (const char* key : {"FRAMES", "PTS_PER_FRAME", "PTS_PER_GROUP", "CHANNELS"})
    EXPECT_THAT(Faults(key, "2147483647"), ReportsOnly(kRecordingCutShort, 0)) << key;
}

TEST_F(RpcFault, ValuesThatAreNone) {
  EXPECT_THAT(Faults("FRAMES", "many"), ReportsOnly(kRpcValue, 0, {"record 11", "FRAMES", "many"}));
  EXPECT_THAT(Faults("FRAMES", "0"), ReportsOnly(kRpcValue, 0));
  EXPECT_THAT(Faults("PTS_PER_FRAME", "4.5"), ReportsOnly(kRpcValue, 0));
  EXPECT_THAT(Faults("DELTA_T", "-1"), ReportsOnly(kRpcValue, 0, {"DELTA_T"}));
  EXPECT_THAT(Faults("SCALE.CHAN_2", ""), ReportsOnly(kRpcValue, 0, {"SCALE.CHAN_2"}));
  EXPECT_THAT(Faults("CHANNELS", "3"),
              testing::AnyOf(ReportsOnly(kRpcKeyMissing, 0), ReportsOnly(kRecordingCutShort, 0)));
}

TEST_F(RpcFault, FormatsThatAreNotRead) {
  EXPECT_THAT(Faults("FORMAT", "HEX"), ReportsOnly(kRpcFormat, 0, {"record 1", "HEX"}));
  EXPECT_THAT(Faults("DATA_TYPE", "LONG"), ReportsOnly(kRpcFormat, 0, {"LONG"}));
  EXPECT_THAT(Faults("FILE_TYPE", "MATRIX"), ReportsOnly(kRpcNotTime, 0, {"MATRIX"}));
  EXPECT_THAT(Faults("TIME_TYPE", "MULT_DRIVE"), ReportsOnly(kRpcNotTime, 0, {"MULT_DRIVE"}));
}

TEST_F(RpcFault, TooFewNumbersInAscii) {
  EXPECT_THAT(FaultsOfBytes(HeaderOf(KeysOf("ASCII")) + std::string(50, ' ') + "1 2 3 x"),
              testing::AnyOf(ReportsOnly(kRpcAscii, 0), ReportsOnly(kRecordingCutShort, 0)));
}

}  // namespace
}  // namespace fourpost::rpc_file_test
