#include "analysis/files/universal/universal_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/universal/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::universal_file_test {
namespace {

using ::testing::ElementsAre;

/// Lines 6 to 11 of a data set 58 of data type `type` with `samples`.
std::string HeadOf(int type, std::size_t samples, bool is_even, const std::string& unit = "N", int function = 1) {
  const auto number = [](auto value, std::size_t width) {
    const std::string text = std::to_string(value);
    return std::string(width - text.size(), ' ') + text;
  };
  const std::string quantity = function == 4 ? "        18" : "        17";
  return "force\nNONE\nNONE\nNONE\nNONE\n" + number(function, 5) +
         "         1    0         0 F_left             7   3 NONE               0   0\n" + number(type, 10) +
         number(samples, 10) + number(is_even ? 1 : 0, 10) + "  0.50000E+00  1.00000E-02  0.00000E+00\n" + quantity +
         "    0    0    0 NONE                 NONE\n        13    0    1    0 Force                " + unit +
         "\n         0    0    0    0 NONE                 NONE\n         0    0    0    0 NONE                 NONE\n";
}

std::string TextSet(const std::string& head, const std::string& numbers) {
  return "    -1\n    58\n" + head + numbers + "    -1\n";
}

std::string BinarySet(const std::string& head, const std::string& data, bool is_big_endian, int floats = 2) {
  return "    -1\n    58b     " + std::to_string(is_big_endian ? 2 : 1) + "     " + std::to_string(floats) +
         "          11  " + std::to_string(data.size()) + "     0     0           0           0\n" + head + data +
         "\n    -1\n";
}

TEST(UniversalFile, BinarySampleOfOthersReadsAsAnIndependentReaderReadsIt) {
  const Recording recording = OpenGood(SampleRecording("binary8byte.uff"))->ReadAll();
  ASSERT_EQ(recording.channels.size(), 1);
  const RecordingChannel& channel = recording.channels.front();
  EXPECT_EQ(channel.name, "sine 5 Hz");
  EXPECT_EQ(channel.unit, "g");
  EXPECT_EQ(channel.point, "1");
  // Its ID lines say nothing.
  EXPECT_EQ(channel.description, "");
  EXPECT_EQ(channel.step_s, 0.01);
  ASSERT_EQ(channel.values.size(), 250);
  // By Python's struct: 250 doubles behind the eleven lines.
  EXPECT_EQ(DigestOf(channel.values), "43e59a845be8a7afac1aa02628802d079adf8c4a3e33d24aa67352a94783e806");
}

TEST(UniversalFile, DescribesChannelsByTheirIdLines) {
  const std::string numbers = "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00\n";
  const Recording recording = ReadBytes(TextSet(HeadOf(2, 4, true), numbers));
  ASSERT_EQ(recording.channels.size(), 1);
  EXPECT_EQ(recording.channels[0].name, "F_left");
  EXPECT_EQ(recording.channels[0].description, "force");
}

TEST(UniversalFile, SampleWithAShortLastLineLongExponentsAndCharactersOfUtf8) {
  const Recording recording = OpenGood(SampleRecording("time-history-not-all-columns-filled.uff"))->ReadAll();
  ASSERT_EQ(recording.channels.size(), 1);
  EXPECT_EQ(recording.channels[0].name, "1x");
  EXPECT_EQ(recording.channels[0].unit, "m/s\xC2\xB2");
  EXPECT_EQ(recording.channels[0].step_s, 5e-5);
  EXPECT_THAT(recording.channels[0].values,
              ElementsAre(-3.81956, -3.56616, -2.98987, -2.62207, -3.22879, -3.63712, -3.90210, -3.69214, -3.42426,
                          -3.48508, -4.03966, -3.46046, -5.84096));
}

TEST(UniversalFile, WithoutFunctionsIsRefusedWithWhatItHolds) {
  Diagnostics diagnostics;
  EXPECT_FALSE(OpenRecording(SampleRecording("1858.uff"), diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kUniversalNothing, 0, {"1858"}));
}

TEST(UniversalFile, IsReadInEveryDataTypeAndOrderOfBytes) {
  const std::vector<float> floats = {1.5F, -2.25F, 3e-7F};
  const std::vector<double> doubles = {1.5, -2.25, 3.14159265358979};
  for (const bool big : {false, true}) {
    EXPECT_THAT(ReadBytes(BinarySet(HeadOf(2, 3, true), BytesOf(floats, big), big)).channels[0].values,
                ElementsAre(1.5, -2.25, static_cast<double>(3e-7F)));
    EXPECT_EQ(ReadBytes(BinarySet(HeadOf(4, 3, true), BytesOf(doubles, big), big)).channels[0].values, doubles);
  }
  EXPECT_THAT(ReadBytes(TextSet(HeadOf(4, 3, true), "  1.500000000000E+00 -2.250000000000E+00  3.141592653590E+00\n"))
                  .channels[0]
                  .values,
              ElementsAre(1.5, -2.25, 3.14159265359));
}

TEST(UniversalFile, HasTimesOfItsOwnWhereTheyAreNotEven) {
  const std::vector<double> pairs = {0, 10, 0.25, 20, 1, 30};
  for (const std::string& file :
       {BinarySet(HeadOf(4, 3, false), BytesOf(pairs), false),
        // Times of single precision before values of double.
        BinarySet(HeadOf(4, 3, false),
                  BytesOf(0.0F) + BytesOf(10.0) + BytesOf(0.25F) + BytesOf(20.0) + BytesOf(1.0F) + BytesOf(30.0),
                  false),
        TextSet(HeadOf(2, 3, false),
                "  0.00000E+00  1.00000E+01  2.50000E-01  2.00000E+01  1.00000E+00  3.00000E+01\n")}) {
    const Recording recording = ReadBytes(file);
    EXPECT_THAT(recording.channels[0].times_s, ElementsAre(0, 0.25, 1));
    EXPECT_THAT(recording.channels[0].values, ElementsAre(10, 20, 30));
    EXPECT_EQ(recording.channels[0].step_s, 0);
  }
}

TEST(UniversalFile, PassesOverOtherSetsAndFaultyLineEnds) {
  std::string lines = "    -1\n   151\nrig 4\nNONE\n\n    -1\n    -1\n    15\n         1         0\n    -1\n" +
                      TextSet(HeadOf(2, 2, true), "  1.00000E+00-2.00000E+000\n");
  for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 3))
    lines.insert(at, "\r\r");
  const Recording recording = ReadBytes(lines);
  EXPECT_EQ(recording.description, "rig 4");
  EXPECT_THAT(recording.channels.at(0).values, ElementsAre(1, -2));
  EXPECT_EQ(recording.channels[0].name, "F_left");
  EXPECT_EQ(recording.channels[0].point, "7 +Z");
  EXPECT_EQ(recording.channels[0].start_s, 0.5);
}

TEST(UniversalFile, UnitsOfTheFileHoldWhereAnAxisStatesNone) {
  // Millimetres and millinewtons: 1000 of them are a metre and a newton.
  const std::string units =
      "    -1\n   164\n         5mm (milli newton)            2\n  1.00000000000000000D+03  1.00000000000000000D+03  "
      "1.00000000000000000D+00\n  2.73149999999999980D+02\n    -1\n";
  const Recording none = ReadBytes(units + TextSet(HeadOf(2, 1, true, "NONE"), "  5.00000E+02\n"));
  EXPECT_EQ(none.channels[0].unit, "N");
  EXPECT_EQ(none.channels[0].values[0], 0.5);
  const Recording stated = ReadBytes(units + TextSet(HeadOf(2, 1, true, "kN"), "  5.00000E+02\n"));
  EXPECT_EQ(stated.channels[0].unit, "kN");
  EXPECT_EQ(stated.channels[0].values[0], 500);
}

TEST(UniversalFile, FrequencyResponsesAreReadWithTheirPhases) {
  const TemporaryFolder folder;
  const UniversalFile file(folder.Write(
      "f.uff", TextSet(HeadOf(5, 2, true, "N", 4), "  1.00000E+00  2.00000E+00  3.00000E+00 -4.00000E+00\n")));
  ASSERT_EQ(file.responses().size(), 1);
  EXPECT_THAT(file.Numbers(file.responses()[0]).values,
              ElementsAre(std::complex<double>(1, 2), std::complex<double>(3, -4)));
}

TEST(UniversalFault, NamesTheLineOrTheByte) {
  const TemporaryFolder folder;
  const UniversalFile few(folder.Write("few.uff", TextSet(HeadOf(2, 3, true), "  1.00000E+00\n")));
  EXPECT_THAT([&] { few.Values(0); }, testing::Throws<RecordingFault>(testing::Property(&RecordingFault::line, 2)));
  EXPECT_THAT(FaultsOfBytes(TextSet(HeadOf(2, 999999999, true), "  1.00000E+00\n")), ReportsOnly(kUniversalValues, 2));
  EXPECT_THAT(FaultsOfBytes(TextSet(HeadOf(3, 1, true), "  1.00000E+00\n")), ReportsOnly(kUniversalField, 9, {"type"}));
  EXPECT_THAT(FaultsOfBytes("    -1\n    58\nforce\n"), Reports(kUniversalEnds));
  EXPECT_THAT(FaultsOfBytes(BinarySet(HeadOf(2, 3, true), BytesOf(1.0F), false)),
              Reports(kUniversalBytes, {"4", "12"}));
  EXPECT_THAT(FaultsOfBytes(BinarySet(HeadOf(2, 1, true), BytesOf(1.0F), false, 1)),
              Reports(kUniversalFloats, {"DEC VMS"}));
  const std::string whole = BinarySet(HeadOf(4, 3, true), BytesOf(std::vector<double>{1, 2, 3}), false);
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, whole.size() - 12)), ReportsOnly(kRecordingCutShort, 0, {"24"}));
}

}  // namespace
}  // namespace fourpost::universal_file_test
