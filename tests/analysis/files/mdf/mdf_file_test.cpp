#include "analysis/files/mdf/mdf_file.h"

#include <zlib.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/mdf/findings.h"
#include "analysis/files/recording/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::mdf_file_test {
namespace {

using ::testing::ElementsAre;

using Links = std::vector<std::uint64_t>;

/// A file of version 4, block by block from the end of what others refer to.
class Mdf4 {
 public:
  Mdf4() : bytes_(Padded("MDF     4.10    fourpost", 64) + std::string(24 + 6 * 8 + 32, '\0')) {}

  /// Its place.
  std::uint64_t Add(const std::string& id, const Links& links, const std::string& data) {
    bytes_.resize((bytes_.size() + 7) / 8 * 8, '\0');
    const std::uint64_t at = bytes_.size();
    bytes_ += Block(id, links, data);
    return at;
  }
  std::uint64_t Text(const std::string& text) { return Add("TX", {}, text + '\0'); }

  std::uint64_t Channel(std::uint64_t next, const std::string& name, const std::string& unit, int kind, int type,
                        unsigned bit, unsigned byte, unsigned bits, std::uint64_t conversion = 0, unsigned flags = 0,
                        unsigned invalid_bit = 0) {
    const std::uint64_t name_at = Text(name);
    const std::uint64_t unit_at = unit.empty() ? 0 : Text(unit);
    const auto small = [](int value) { return std::string(1, static_cast<char>(value)); };
    return Add("CN", {next, 0, name_at, 0, conversion, 0, unit_at, 0},
               small(kind) + small(kind == 2 || kind == 3 ? 1 : 0) + small(type) + small(static_cast<int>(bit)) +
                   BytesOf(byte) + BytesOf(bits) + BytesOf(flags) + BytesOf(invalid_bit) + std::string(52, '\0'));
  }
  std::uint64_t Conversion(int type, const std::vector<double>& numbers) {
    return Add("CC", {0, 0, 0, 0},
               std::string(1, static_cast<char>(type)) + std::string(5, '\0') +
                   BytesOf(static_cast<std::uint16_t>(numbers.size())) + std::string(16, '\0') + BytesOf(numbers));
  }
  std::uint64_t Group(std::uint64_t next, std::uint64_t channels, std::uint64_t data, std::uint64_t cycles,
                      unsigned record, unsigned invalid = 0, std::uint64_t other_group = 0) {
    const std::uint64_t group = Add(
        "CG", {other_group, channels, 0, 0, 0, 0},
        BytesOf(std::uint64_t{0}) + BytesOf(cycles) + BytesOf(std::uint64_t{0}) + BytesOf(record) + BytesOf(invalid));
    return Add("DG", {next, group, data, 0}, std::string(8, '\0'));
  }
  std::uint64_t Data(const std::string& records) { return Add("DT", {}, records); }
  std::uint64_t Packed(const std::string& records, unsigned row) {
    std::string stored = records;
    // Column after column.
    for (std::size_t i = 0; row > 0 && i < records.size() / row * row; ++i)
      stored[i % row * (records.size() / row) + i / row] = records[i];
    uLongf size = compressBound(stored.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(stored.data()),
             stored.size());
    packed.resize(size);
    return Add("DZ", {},
               "DT" + std::string(1, row > 0 ? '\1' : '\0') + std::string(1, '\0') + BytesOf(row) +
                   BytesOf(std::uint64_t{records.size()}) + BytesOf(std::uint64_t{size}) + packed);
  }

  std::string Bytes(std::uint64_t first_group) const {
    std::string all = bytes_;
    return all.replace(64, 24 + 6 * 8 + 32, Block("HD", {first_group, 0, 0, 0, 0, 0}, std::string(32, '\0')));
  }

 private:
  static std::string Block(const std::string& id, const Links& links, const std::string& data) {
    return "##" + id + std::string(4, '\0') + BytesOf(std::uint64_t{24 + 8 * links.size() + data.size()}) +
           BytesOf(std::uint64_t{links.size()}) + BytesOf(links) + data;
  }

  std::string bytes_;
};

/// Times 0, 0.1, ... and counts 0, -10, -20, ..., which 0.5 x + 100 converts; `data` gives the place of the records.
template <typename Data>
std::string FileOf(const Data& data) {
  Mdf4 file;
  std::string records;
  for (int k = 0; k < 5; ++k) records += BytesOf(0.1 * k) + BytesOf(static_cast<std::int16_t>(-10 * k));
  const std::uint64_t count = file.Channel(0, "count", "mm", 0, 2, 0, 8, 16, file.Conversion(1, {100, 0.5}));
  const std::uint64_t time = file.Channel(count, "t", "s", 2, 4, 0, 0, 64);
  return file.Bytes(file.Group(0, time, data(file, records), 5, 10));
}

void ExpectCounts(const std::string& bytes) {
  const Recording recording = ReadBytes(bytes);
  ASSERT_EQ(recording.channels.size(), 1);
  EXPECT_EQ(recording.channels[0].name, "count");
  EXPECT_EQ(recording.channels[0].unit, "mm");
  EXPECT_THAT(recording.channels[0].values, ElementsAre(100, 95, 90, 85, 80));
  EXPECT_EQ(recording.channels[0].times_s, (std::vector<double>{0, 0.1, 0.1 * 2, 0.1 * 3, 0.1 * 4}));
}

TEST(MdfFile, OfVersion4IsReadFromEveryKindOfDataBlock) {
  ExpectCounts(FileOf([](Mdf4& file, const std::string& records) { return file.Data(records); }));
  for (const unsigned row : {0U, 10U})
    ExpectCounts(FileOf([row](Mdf4& file, const std::string& records) { return file.Packed(records, row); }));
  ExpectCounts(FileOf([](Mdf4& file, const std::string& records) {
    // Lists in a list; blocks end within records.
    const std::uint64_t last = file.Add("DL", {0, file.Packed(records.substr(37), 10)}, std::string(16, '\0'));
    const std::uint64_t list = file.Add(
        "DL", {last, file.Data(records.substr(0, 13)), file.Packed(records.substr(13, 24), 10)}, std::string(24, '\0'));
    return file.Add("HL", {list}, std::string(8, '\0'));
  }));
}

TEST(MdfFile, OfVersion4HasNumbersOfEveryKindAndPlace) {
  Mdf4 file;
  // A float, an integer of 12 bits from bit 4 on, one of 16 bits big endian, and a byte of invalidation bits.
  const std::string records = BytesOf(1.5F) + std::string("\xF0\x7F", 2) + BytesOf(std::int16_t{-2}, true) + '\0' +
                              BytesOf(2.5F) + std::string("\x1F\x80", 2) + BytesOf(std::int16_t{300}, true) + '\1';
  const std::uint64_t big = file.Channel(0, "big", "", 0, 3, 0, 6, 16);
  const std::uint64_t bits = file.Channel(big, "bits", "", 0, 2, 4, 4, 12, 0, 2, 0);
  const std::uint64_t rational =
      file.Channel(bits, "rational", "", 0, 4, 0, 0, 32, file.Conversion(2, {0, 2, 1, 0, 0, 4}));
  const std::uint64_t table =
      file.Channel(rational, "table", "", 0, 4, 0, 0, 32, file.Conversion(4, {1, 10, 2, 20, 3, 40}));
  const std::uint64_t time = file.Channel(table, "t", "s", 3, 0, 0, 0, 0, file.Conversion(1, {5, 0.25}));
  const Recording recording = ReadBytes(file.Bytes(file.Group(0, time, file.Data(records), 2, 8, 1)));
  ASSERT_EQ(recording.channels.size(), 4);
  EXPECT_THAT(recording.channels[0].values, ElementsAre(15, 30));
  EXPECT_THAT(recording.channels[1].values, ElementsAre(1, 1.5));
  EXPECT_EQ(recording.channels[2].values[0], 0x7FF);
  EXPECT_TRUE(std::isnan(recording.channels[2].values[1]));
  EXPECT_THAT(recording.channels[3].values, ElementsAre(-2, 300));
  EXPECT_THAT(recording.channels[0].times_s, ElementsAre(5, 5.25));
}

TEST(MdfFile, GroupsHaveRatesOfTheirOwn) {
  Mdf4 file;
  const auto group = [&](std::uint64_t next, double step, int count) {
    std::string records;
    for (int k = 0; k < count; ++k) records += BytesOf(step * k) + BytesOf(static_cast<double>(k));
    const std::uint64_t time = file.Channel(file.Channel(0, "x", "m", 0, 4, 0, 8, 64), "t", "s", 2, 4, 0, 0, 64);
    return file.Group(next, time, file.Data(records), count, 16);
  };
  const Recording recording = ReadBytes(file.Bytes(group(group(0, 0.5, 3), 0.25, 5)));
  ASSERT_EQ(recording.channels.size(), 2);
  EXPECT_EQ(recording.channels[0].name, "group 1/x");
  EXPECT_EQ(recording.channels[1].name, "group 2/x");
  EXPECT_THAT(recording.channels[0].times_s, ElementsAre(0, 0.25, 0.5, 0.75, 1));
  EXPECT_THAT(recording.channels[1].times_s, ElementsAre(0, 0.5, 1));
}

/// A file of version 3 with times and counts as FileOf().
std::string OldFile(bool big) {
  std::string bytes = Padded("MDF     3.30    fourpost", 64);
  bytes.replace(24, 4, BytesOf(static_cast<std::uint16_t>(big ? 1 : 0)) + BytesOf(static_cast<std::uint16_t>(330)));
  const auto block = [&](const std::string& id, std::string data) {
    const auto at = static_cast<std::uint32_t>(bytes.size());
    bytes += id + BytesOf(static_cast<std::uint16_t>(data.size() + 4), big) + data;
    return at;
  };
  const auto word = [&](std::uint32_t value) { return BytesOf(value, big); };
  const auto half = [&](int value) { return BytesOf(static_cast<std::uint16_t>(value), big); };
  block("HD", word(0) + word(0) + word(0) + half(1) + std::string(138, '\0'));
  const std::uint32_t linear = block("CC", half(0) + std::string(16, '\0') + Padded("mm", 20) + half(0) + half(2) +
                                               BytesOf(100.0, big) + BytesOf(0.5, big));
  const auto channel = [&](std::uint32_t next, const std::string& name, std::uint32_t conversion, int kind, int bit,
                           int bits, int type) {
    return block("CN", word(next) + word(conversion) + word(0) + word(0) + word(0) + half(kind) + Padded(name, 32) +
                           std::string(128, '\0') + half(bit) + half(bits) + half(type) + half(0) +
                           std::string(24, '\0') + word(0) + word(0) + half(0));
  };
  const std::uint32_t count = channel(0, "count", linear, 0, 64, 16, 1);
  const std::uint32_t time = channel(count, "t", 0, 1, 0, 64, 3);
  const std::uint32_t group = block("CG", word(0) + word(time) + word(0) + half(0) + half(2) + half(10) + word(5));
  const auto data = static_cast<std::uint32_t>(bytes.size());
  for (int k = 0; k < 5; ++k) bytes += BytesOf(0.1 * k, big) + BytesOf(static_cast<std::int16_t>(-10 * k), big);
  const std::uint32_t data_group =
      block("DG", word(0) + word(group) + word(0) + word(data) + half(1) + half(0) + word(0));
  return bytes.replace(68, 4, word(data_group));
}

TEST(MdfFile, OfVersion3IsReadInBothOrdersOfBytes) {
  ExpectCounts(OldFile(false));
  ExpectCounts(OldFile(true));
}

TEST(MdfFile, TextsAreLeftOutWithARemark) {
  Mdf4 file;
  const std::uint64_t text = file.Channel(0, "note", "", 0, 6, 0, 0, 64);
  const std::uint64_t state = file.Channel(text, "state", "", 0, 0, 0, 0, 8, file.Conversion(7, {1}));
  const std::uint64_t number = file.Channel(state, "x", "", 0, 4, 0, 0, 64);
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto opened =
      OpenRecording(folder.Write("f", file.Bytes(file.Group(0, number, file.Data(BytesOf(3.5)), 1, 8))), diagnostics);
  ASSERT_TRUE(opened);
  EXPECT_THAT(opened->Values(0), ElementsAre(3.5));
  EXPECT_THAT(diagnostics, ReportsOnly(kChannelsLeftOut, 0, {"note", "state"}));
}

TEST(MdfFault, NamesTheByte) {
  const std::string good = FileOf([](Mdf4& file, const std::string& records) { return file.Data(records); });
  const auto broken = [&](std::size_t at, const std::string& bytes) {
    return FaultsOfBytes(std::string(good).replace(at, bytes.size(), bytes));
  };
  EXPECT_THAT(broken(64, "##XX"), ReportsOnly(kMdfBlock, 0, {"HD", "64"}));
  EXPECT_THAT(broken(88, BytesOf(std::uint64_t{1} << 50)), ReportsOnly(kRecordingCutShort, 0));
  EXPECT_THAT(broken(0, "UnFinMF "), ReportsOnly(kMdfNotFinished, 0));
  EXPECT_THAT(broken(8, "5.00"), ReportsOnly(kMdfVersion, 0, {"5.00"}));
  EXPECT_THAT(FaultsOfBytes(good.substr(0, 70)), ReportsOnly(kRecordingCutShort, 0));
  // The first data group is the last block: its successor is itself.
  const std::size_t group = good.rfind("##DG");
  EXPECT_THAT(broken(group + 24, BytesOf(std::uint64_t{group})), ReportsOnly(kMdfBlock, 0, {"circle"}));
  const std::size_t channels = good.rfind("##CG");
  EXPECT_THAT(broken(channels + 24 + 48 + 8, BytesOf(std::uint64_t{1} << 60)),
              ReportsOnly(kMdfCycles, 0, {std::to_string(channels)}));
  EXPECT_THAT(broken(channels + 24, BytesOf(std::uint64_t{channels})), ReportsOnly(kMdfBlock, 0));
}

TEST(MdfFault, UnsortedAndUnknownDataAreRefusedByName) {
  Mdf4 two;
  const std::uint64_t channel = two.Channel(0, "x", "", 0, 4, 0, 0, 64);
  const std::uint64_t other = two.Add("CG", {0, 0, 0, 0, 0, 0}, std::string(32, '\0'));
  const std::uint64_t data = two.Data(BytesOf(1.0));
  EXPECT_THAT(FaultsOfBytes(two.Bytes(two.Group(0, channel, data, 1, 8, 0, other))), ReportsOnly(kMdfUnsorted, 0));
  EXPECT_THAT(FaultsOfBytes(FileOf([](Mdf4& file, const std::string& records) { return file.Add("DV", {}, records); })),
              ReportsOnly(kMdfData, 0, {"DV"}));
}

TEST(MdfFault, PackedDataThatAreNone) {
  std::string bytes = FileOf([](Mdf4& file, const std::string& records) { return file.Packed(records, 10); });
  const std::size_t packed = bytes.rfind("##DZ");
  Diagnostics diagnostics;
  const TemporaryFolder folder;
  const auto file = OpenRecording(folder.Write("f", std::string(bytes).replace(packed + 52, 4, "none")), diagnostics);
  ASSERT_TRUE(file);
  EXPECT_ANY_THROW(file->Values(0));
  // Lengths that no packing explains.
  EXPECT_THAT(FaultsOfBytes(bytes.replace(packed + 32, 8, BytesOf(std::uint64_t{1} << 40))),
              ReportsOnly(kMdfBlock, 0, {std::to_string(packed)}));
}

}  // namespace
}  // namespace fourpost::mdf_file_test
