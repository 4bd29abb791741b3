#include "analysis/files/tdms/tdms_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/recording/findings.h"
#include "analysis/files/tdms/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::tdms_file_test {
namespace {

using ::testing::ElementsAre;

enum : std::uint32_t { kFloat = 9, kDouble = 10, kText = 0x20, kTimeStamp = 0x44 };
enum : std::uint32_t { kMetaData = 2, kNewObjects = 4, kRawData = 8, kInterleaved = 32, kBigEndian = 64 };
constexpr std::uint32_t kShort = 2;

/// A segment of a TDMS file, in one order of bytes.
class Segment {
 public:
  explicit Segment(bool is_big_endian = false) : big_(is_big_endian) {}

  std::string Text(const std::string& text) const {
    return BytesOf(static_cast<std::uint32_t>(text.size()), big_) + text;
  }
  std::string Property(const std::string& name, double value) const {
    return Text(name) + BytesOf(std::uint32_t{kDouble}, big_) + BytesOf(value, big_);
  }
  std::string Property(const std::string& name, const std::string& value) const {
    return Text(name) + BytesOf(std::uint32_t{kText}, big_) + Text(value);
  }
  std::string Number(const std::string& name, std::uint32_t value) const {
    return Text(name) + BytesOf(std::uint32_t{7}, big_) + BytesOf(value, big_);
  }

  void Add(const std::string& path, std::uint32_t type, std::uint64_t count,
           const std::vector<std::string>& properties = {}) {
    AddObject(
        path,
        BytesOf(std::uint32_t{20}, big_) + BytesOf(type, big_) + BytesOf(std::uint32_t{1}, big_) + BytesOf(count, big_),
        properties);
  }
  /// `index`: 0xFFFFFFFF without data, 0 as before.
  void Add(const std::string& path, std::uint32_t index, const std::vector<std::string>& properties = {}) {
    AddObject(path, BytesOf(index, big_), properties);
  }
  void AddObject(const std::string& path, const std::string& index, const std::vector<std::string>& properties) {
    objects_ += Text(path) + index + BytesOf(static_cast<std::uint32_t>(properties.size()), big_);
    for (const std::string& property : properties) objects_ += property;
    ++count_;
  }

  std::string Bytes(const std::string& data, std::uint32_t mask = kNewObjects) const {
    const std::string meta = count_ == 0 ? "" : BytesOf(count_, big_) + objects_;
    const std::uint32_t all =
        mask | (count_ == 0 ? 0U : std::uint32_t{kMetaData}) | kRawData | (big_ ? std::uint32_t{kBigEndian} : 0U);
    return "TDSm" + BytesOf(all) + BytesOf(std::uint32_t{4713}, big_) +
           BytesOf(std::uint64_t{meta.size() + data.size()}, big_) + BytesOf(std::uint64_t{meta.size()}, big_) + meta +
           data;
  }

 private:
  bool big_;
  std::uint32_t count_ = 0;
  std::string objects_;
};

/// Two channels of two numbers a chunk.
Segment Pair(bool big = false) {
  Segment segment(big);
  segment.Add("/", 0xFFFFFFFF, {segment.Property("name", "rig 4")});
  segment.Add("/'run'", 0xFFFFFFFF);
  segment.Add("/'run'/'F'", kDouble, 2,
              {segment.Property("wf_increment", 0.002), segment.Property("wf_start_offset", 0.5),
               segment.Property("unit_string", "kN")});
  segment.Add("/'run'/'it''s z'", kShort, 2);
  return segment;
}

std::string Chunk(double a, double b, std::int16_t c, std::int16_t d, bool big = false) {
  return BytesOf(a, big) + BytesOf(b, big) + BytesOf(c, big) + BytesOf(d, big);
}

TEST(TdmsFile, ChannelsHaveTheirNamesUnitsAndTimes) {
  const Recording recording = ReadBytes(Pair().Bytes(Chunk(1.5, 2.5, -3, 4)));
  ASSERT_EQ(recording.channels.size(), 2);
  EXPECT_EQ(recording.description, "rig 4");
  const RecordingChannel& force = recording.channels[0];
  EXPECT_EQ(force.name, "F");
  EXPECT_EQ(force.group, "run");
  EXPECT_EQ(force.unit, "kN");
  EXPECT_EQ(force.step_s, 0.002);
  EXPECT_EQ(force.start_s, 0.5);
  EXPECT_EQ(recording.channels[1].name, "it's z");
  EXPECT_FALSE(recording.channels[1].HasTimes());
}

TEST(TdmsFile, SegmentsChunksAndOrdersOfBytesFollowEachOther) {
  for (const bool big : {false, true}) {
    // Two chunks, then one by the same objects without properties, then a list with one of them.
    Segment again(big);
    again.Add("/'run'/'F'", std::uint32_t{0});
    const Recording recording =
        ReadBytes(Pair(big).Bytes(Chunk(1, 2, 10, 20, big) + Chunk(3, 4, 30, 40, big)) +
                  Segment(big).Bytes(Chunk(5, 6, 50, 60, big), 0) + again.Bytes(BytesOf(7.0, big) + BytesOf(8.0, big)));
    EXPECT_THAT(recording.channels[0].values, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(recording.channels[1].values, ElementsAre(10, 20, 30, 40, 50, 60));
  }
}

TEST(TdmsFile, InterleavedChannelsStandRowByRow) {
  Segment segment;
  segment.Add("/'g'/'a'", kFloat, 3);
  segment.Add("/'g'/'b'", kShort, 3);
  std::string rows;
  for (int k = 0; k < 3; ++k) rows += BytesOf(0.5F * static_cast<float>(k)) + BytesOf(static_cast<std::int16_t>(-k));
  const Recording recording = ReadBytes(segment.Bytes(rows, kNewObjects | kInterleaved));
  EXPECT_THAT(recording.channels[0].values, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(recording.channels[1].values, ElementsAre(0, -1, -2));
}

TEST(TdmsFile, ScalingsAreAppliedOneBehindTheOther) {
  Segment segment;
  const auto scale = [&](const std::string& name) { return "NI_Scale[" + name; };
  // 2 x - 1, then 0.5 + y + 3 y^2.
  const std::vector<std::string> properties = {segment.Number("NI_Number_Of_Scales", 2),
                                               segment.Property(scale("0]_Scale_Type"), "Linear"),
                                               segment.Property(scale("0]_Linear_Slope"), 2),
                                               segment.Property(scale("0]_Linear_Y_Intercept"), -1),
                                               segment.Number(scale("0]_Linear_Input_Source"), 0xFFFFFFFF),
                                               segment.Property(scale("1]_Scale_Type"), "Polynomial"),
                                               segment.Number(scale("1]_Polynomial_Coefficients_Size"), 3),
                                               segment.Property(scale("1]_Polynomial_Coefficients[0]"), 0.5),
                                               segment.Property(scale("1]_Polynomial_Coefficients[1]"), 1),
                                               segment.Property(scale("1]_Polynomial_Coefficients[2]"), 3),
                                               segment.Number(scale("1]_Polynomial_Input_Source"), 0)};
  segment.Add("/'g'/'a'", kShort, 2, properties);
  EXPECT_THAT(ReadBytes(segment.Bytes(BytesOf(std::vector<std::int16_t>{1, 2}))).channels[0].values,
              ElementsAre(4.5, 30.5));
}

TEST(TdmsFile, OtherScalingsAndTextsAreLeftOutWithARemark) {
  Segment segment;
  segment.Add("/'g'/'a'", kShort, 2);
  segment.Add("/'g'/'hot'", kShort, 2,
              {segment.Number("NI_Number_Of_Scales", 1), segment.Property("NI_Scale[0]_Scale_Type", "Thermocouple")});
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto file =
      OpenRecording(folder.Write("t", segment.Bytes(BytesOf(std::vector<std::int16_t>{1, 2, 3, 4}))), diagnostics);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->header().channels.size(), 1);
  EXPECT_THAT(diagnostics, ReportsOnly(kTdmsScale, 0, {"hot"}));
}

TEST(TdmsFile, TimeStampsAreSecondsAfterTheFirst) {
  Segment segment;
  segment.Add("/'g'/'t'", kTimeStamp, 2);
  const std::uint64_t half = std::uint64_t{1} << 63;
  const Recording recording = ReadBytes(segment.Bytes(BytesOf(std::uint64_t{0}) + BytesOf(std::int64_t{3'800'000'000}) +
                                                      BytesOf(half) + BytesOf(std::int64_t{3'800'000'001})));
  EXPECT_THAT(recording.channels[0].values, ElementsAre(0, 1.5));
  EXPECT_EQ(recording.channels[0].unit, "s");
}

TEST(TdmsFile, WhatWasBeingWrittenIsReadUpToItsLastWholeChunk) {
  std::string bytes = Pair().Bytes(Chunk(1, 2, 3, 4) + Chunk(5, 6, 7, 8)).substr(0, 1000);
  // The length of the segment was not written.
  bytes.replace(12, 8, BytesOf(~std::uint64_t{0}));
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto file = OpenRecording(folder.Write("t", bytes.substr(0, bytes.size() - 3)), diagnostics);
  ASSERT_TRUE(file);
  EXPECT_THAT(file->Values(0), ElementsAre(1, 2));
  EXPECT_THAT(diagnostics, ReportsOnly(kTdmsCut, 0));
}

TEST(TdmsFault, NamesTheByte) {
  const std::string good = Pair().Bytes(Chunk(1, 2, 3, 4));
  EXPECT_THAT(FaultsOfBytes(good + "TDSx" + std::string(40, '\0')),
              ReportsOnly(kTdmsSegment, 0, {std::to_string(good.size())}));
  EXPECT_THAT(FaultsOfBytes(good.substr(0, 20)), ReportsOnly(kRecordingCutShort, 0, {"28", "20"}));
  EXPECT_THAT(FaultsOfBytes("TDSh" + good.substr(4)), ReportsOnly(kTdmsIndex, 0));
  std::string raw = good;
  raw.replace(20, 8, BytesOf(std::uint64_t{1} << 40));
  EXPECT_THAT(FaultsOfBytes(raw), ReportsOnly(kTdmsLead, 0, {"byte 0"}));
}

TEST(TdmsFault, RawDataOfDaqmxAreRefusedByName) {
  for (const std::uint32_t index : {0x1269U, 0x126AU}) {
    Segment segment;
    segment.AddObject("/'g'/'a'", BytesOf(index), {});
    EXPECT_THAT(FaultsOfBytes(segment.Bytes("")), ReportsOnly(kTdmsDaqmx, 0, {"DAQmx", "/'g'/'a'"}));
  }
}

TEST(TdmsFault, NumbersThatTheFileCannotHold) {
  Segment many;
  many.Add("/'g'/'a'", kDouble, std::uint64_t{1} << 60);
  EXPECT_THAT(FaultsOfBytes(many.Bytes("12345678")), ReportsOnly(kTdmsObject, 0));
  Segment unknown;
  unknown.Add("/'g'/'a'", 99, 1);
  EXPECT_THAT(FaultsOfBytes(unknown.Bytes("12345678")), ReportsOnly(kTdmsObject, 0, {"type 99"}));
  Segment orphan;
  orphan.Add("/'g'/'a'", std::uint32_t{0});
  EXPECT_THAT(FaultsOfBytes(orphan.Bytes("12345678")), ReportsOnly(kTdmsObject, 0, {"beginning"}));
}

}  // namespace
}  // namespace fourpost::tdms_file_test
