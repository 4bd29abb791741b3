#include "analysis/files/lvm/lvm_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/lvm/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::lvm_file_test {
namespace {

using ::testing::ElementsAre;

const char kHead[] =
    "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\nX_Columns\tOne\n"
    "Description\trig 4\n***End_of_Header***\t\n\t\n";
const char kPart[] =
    "Channels\t2\t\t\nSamples\t3\t3\t\nY_Unit_Label\tkN\tmm\nX_Dimension\tTime\tTime\t\nX0\t0.0E+0\t0.0E+0\t\n"
    "Delta_X\t1.0E-3\t1.0E-3\t\n***End_of_Header***\t\t\t\n";

/// kPart with other numbers of samples.
std::string Samples(int first, int second) {
  return Replace(kPart, "Samples\t3\t3", "Samples\t" + std::to_string(first) + "\t" + std::to_string(second));
}

TEST(LvmFile, HasOneColumnOfTimesNoneOrOneAChannel) {
  const std::string one =
      "X_Value\tF\tz\tComment\n0.000000\t1.5\t-2\n0.001000\t2.5\t-3\tfirst hit\n0.002000\t3.5\t-4\n";
  const std::string none = "X_Value\tF\tz\tComment\n\t1.5\t-2\n\t2.5\t-3\n\t3.5\t-4\n";
  const std::string each =
      "X_Value\tF\tX_Value\tz\tComment\n0\t1.5\t0\t-2\n0.001\t2.5\t0.001\t-3\n0.002\t3.5\t0.002\t-4\n";
  for (const std::string& rows : {one, none, each}) {
    const Recording recording = ReadBytes(kHead + std::string(kPart) + rows);
    ASSERT_EQ(recording.channels.size(), 2);
    EXPECT_EQ(recording.description, "rig 4");
    EXPECT_EQ(recording.channels[0].name, "F");
    EXPECT_EQ(recording.channels[0].unit, "kN");
    EXPECT_EQ(recording.channels[1].unit, "mm");
    EXPECT_EQ(recording.channels[0].step_s, 0.001);
    EXPECT_THAT(recording.channels[0].values, ElementsAre(1.5, 2.5, 3.5));
    EXPECT_THAT(recording.channels[1].values, ElementsAre(-2, -3, -4));
  }
}

// A tab behind the key, or nothing at all.
TEST(LvmFile, MayHaveKeysWithoutAValue) {
  for (const char* nothing : {"", "\t", "\t\t\t"}) {
    const std::string keys = std::string("Operator") + nothing + "\nDate" + nothing + "\nTime" + nothing + "\n";
    std::string head = Replace(kHead, "X_Columns", keys + "X_Columns");
    head = Replace(head, "Description\trig 4", std::string("Description") + nothing);
    const std::string part = Replace(Replace(kPart, "X_Dimension", keys + "X_Dimension"), "X0\t0.0E+0\t0.0E+0\t",
                                     std::string("X0") + nothing);
    const Recording recording = ReadBytes(head + part + "X_Value\tF\tz\n0\t1\t2\n0.001\t3\t4\n0.002\t5\t6\n");
    EXPECT_EQ(recording.description, "");
    EXPECT_EQ(recording.channels[1].unit, "mm");
    EXPECT_THAT(recording.channels[1].values, ElementsAre(2, 4, 6));
  }
}

TEST(LvmFile, HasDecimalCommas) {
  std::string head = kHead;
  head = Replace(head, "Decimal_Separator\t.", "Decimal_Separator\t,");
  EXPECT_THAT(ReadBytes(head + Samples(1, 1) + "X_Value\tF\tz\n0,000\t1,5\t2\n").channels[0].values, ElementsAre(1.5));
}

TEST(LvmFile, PartsFollowEachOther) {
  const std::string second = Replace(Samples(1, 1), "X0\t0.0E+0\t0.0E+0", "X0\t1.0E+0\t1.0E+0");
  const Recording recording = ReadBytes(kHead + Samples(2, 2) + "X_Value\tF\tz\n0\t1\t2\n0.001\t3\t4\n\n" + second +
                                        "X_Value\tF\tz\n1\t5\t6\n");
  EXPECT_THAT(recording.channels[0].values, ElementsAre(1, 3, 5));
  EXPECT_THAT(recording.channels[0].times_s, ElementsAre(0, 0.001, 1));
  EXPECT_EQ(recording.channels[0].step_s, 0);
}

TEST(LvmFile, EmptyFieldsAreNaN) {
  const Recording recording = ReadBytes(kHead + Samples(2, 1) + "X_Value\tF\tz\n0\t\t2\n0.001\t3\t\n");
  EXPECT_TRUE(std::isnan(recording.channels[0].values[0]));
  // Of a channel that is shorter.
  EXPECT_THAT(recording.channels[1].values, ElementsAre(2));
}

TEST(LvmFault, NamesTheLine) {
  EXPECT_THAT(FaultsOfBytes("LabVIEW Measurement\t\nWriter_Version\t2\n"), ReportsOnly(kLvmHeader, 2));
  EXPECT_THAT(FaultsOfBytes(kHead + std::string(kPart)), ReportsOnly(kLvmNames, 15));
  EXPECT_THAT(FaultsOfBytes(kHead + std::string(kPart) + "X_Value\tF\tz\n0\tone\t2\n"),
              ReportsOnly(kLvmNumber, 17, {"one", "F"}));
  EXPECT_THAT(FaultsOfBytes(kHead + Samples(1, 1) + "X_Value\tF\tz\n0\t1\t2\n\n" + kPart + "X_Value\tF\n0\t1\n"),
              Reports(kLvmChannels, {"1", "2"}));
}

TEST(LvmFault, IsAFileThatEndsBeforeItsSamples) {
  const std::string whole = kHead + std::string(kPart) + "X_Value\tF\tz\n0\t1\t2\n0.001\t3\t4\n0.002\t5\t6\n";
  EXPECT_EQ(ReadBytes(whole).channels[1].values.size(), 3);
  // Within the last row, and within the row before it.
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, whole.size() - 2)),
              Reports(kLvmCutShort, {"2 samples", "'z'", "header 3"}));
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, whole.size() - 14)), Reports(kLvmCutShort, {"'F'"}));
}

}  // namespace
}  // namespace fourpost::lvm_file_test
