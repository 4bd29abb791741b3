#include "analysis/files/mat_file.h"

#include <hdf5.h>
#include <zlib.h>

#include <fstream>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "analysis/files/mat/findings.h"
#include "analysis/files/time_recording.h"
#include "tests/analysis/files/mat_writer.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::mat_file_test {
namespace {

using testing::ElementsAre;

std::vector<MatVector> Read(const std::string& file) {
  Diagnostics diagnostics;
  std::optional<std::vector<MatVector>> vectors = ReadMatFile(file, diagnostics);
  if (!vectors) throw std::runtime_error(diagnostics.Format());
  return *vectors;
}

Diagnostics Faults(const std::string& file) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadMatFile(file, diagnostics));
  return diagnostics;
}

class MatVersions : public testing::TestWithParam<mat_ft> {
 protected:
  TemporaryFolder folder_;
  std::string file_ = (folder_.path() / "run.mat").string();
};

TEST_P(MatVersions, HoldVectorsAndTheirUnits) {
  {
    MatWriter mat(file_, GetParam());
    mat.Add(MatWriter::Column("force", {1, 2, 3}));
    mat.Add(MatWriter::Text("force_unit", "kN"));
    mat.Add(MatWriter::Text("comment", "third run"));
  }
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 1u);
  EXPECT_EQ(vectors[0].name, "force");
  EXPECT_EQ(vectors[0].unit, "kN");
  EXPECT_THAT(vectors[0].values, ElementsAre(1, 2, 3));
}

TEST_P(MatVersions, HoldRowsOfCharacters) {
  {
    MatWriter mat(file_, GetParam());
    mat.Add(MatWriter::Rows("channel", {"a_body", "s_strut"}));
    mat.Add(MatWriter::Column("gain", {1, 2}));
  }
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 2u);
  EXPECT_EQ(vectors[0].name, "channel");
  EXPECT_THAT(vectors[0].texts, ElementsAre("a_body", "s_strut"));
}

/// Those that have cells.
using LaterMatVersions = MatVersions;

TEST_P(LaterMatVersions, HoldCellsOfTexts) {
  {
    MatWriter mat(file_, GetParam());
    mat.Add(MatWriter::Cells("channel", {"a_body", "s"}));
    mat.Add(MatWriter::Column("gain", {1, 2}));
  }
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 2u);
  EXPECT_THAT(vectors[0].texts, ElementsAre("a_body", "s"));
}

std::string VersionName(const testing::TestParamInfo<mat_ft>& test) {
  return test.param == MAT_FT_MAT4 ? "Version4" : test.param == MAT_FT_MAT5 ? "Version5" : "Version73";
}

INSTANTIATE_TEST_SUITE_P(All, MatVersions, testing::Values(MAT_FT_MAT4, MAT_FT_MAT5, MAT_FT_MAT73), VersionName);
INSTANTIATE_TEST_SUITE_P(All, LaterMatVersions, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73), VersionName);

class MatFile : public testing::Test {
 protected:
  void Write(const std::vector<matvar_t*>& variables) {
    MatWriter mat(file_, MAT_FT_MAT5);
    for (matvar_t* variable : variables) mat.Add(variable);
  }

  TemporaryFolder folder_;
  std::string file_ = (folder_.path() / "run.mat").string();
};

TEST_F(MatFile, HoldsStructuresOfChannels) {
  Write({MatWriter::Struct("run", {{"time", MatWriter::Column(nullptr, {0, 1})},
                                   {"force", MatWriter::Struct(nullptr, {{"data", MatWriter::Column(nullptr, {5, 6})},
                                                                         {"unit", MatWriter::Text(nullptr, "N")}})}}),
         MatWriter::Struct("units", {{"time", MatWriter::Text(nullptr, "ms")}})});
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 2u);
  EXPECT_EQ(vectors[0].name, "time");
  EXPECT_EQ(vectors[0].unit, "ms");
  EXPECT_EQ(vectors[1].name, "force");
  EXPECT_EQ(vectors[1].unit, "N");
  EXPECT_THAT(vectors[1].values, ElementsAre(5, 6));
}

TEST_F(MatFile, MayHaveNotesBesideItsChannels) {
  const auto channel = [](const char* name, const char* unit) {
    return MatWriter::Struct(name, {{"data", MatWriter::Column(nullptr, {5, 6})},
                                    {"unit", MatWriter::Text(nullptr, unit)},
                                    {"notes", MatWriter::Cells(nullptr, {"x", "y"})}});
  };
  Write({channel("force", "N"), channel("stroke", "mm")});
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 3u);
  EXPECT_EQ(vectors[0].name, "force");
  EXPECT_EQ(vectors[0].unit, "N");
  EXPECT_EQ(vectors[2].name, "stroke");
  EXPECT_EQ(vectors[2].unit, "mm");
}

// A field called unit that is none, and numbers a level further down.
TEST_F(MatFile, TakesTheUnitOfTheOnlyNumbersOfAStructure) {
  Write(
      {MatWriter::Struct("odd",
                         {{"unit", MatWriter::Column(nullptr, {1, 2})}, {"units", MatWriter::Text(nullptr, "N")}}),
       MatWriter::Struct("deep", {{"force", MatWriter::Struct(nullptr, {{"data", MatWriter::Column(nullptr, {5, 6})}})},
                                  {"unit", MatWriter::Text(nullptr, "kN")}})});
  const std::vector<MatVector> vectors = Read(file_);
  ASSERT_EQ(vectors.size(), 1u);
  EXPECT_EQ(vectors[0].name, "force");
  EXPECT_EQ(vectors[0].unit, "kN");
}

TEST_F(MatFile, IsARecordingWithTheUnitsOfItsStudy) {
  Write({MatWriter::Column("Tout", {0, 0.01, 0.02, 0.03, 0.04}), MatWriter::Column("forc", {1, 2, 3, 4, 5})});
  Diagnostics diagnostics;
  const RecordedChannel time{.names = {"Tout"}, .dimension = kTime, .what = "the times", .unit = "s"};
  const std::vector<RecordedChannel> wanted = {
      {.names = {"forc"}, .dimension = kForce, .what = "the force", .unit = "kN", .factor = -2}};
  const auto recording = ReadTimeRecording(file_, wanted, diagnostics, time);
  ASSERT_TRUE(recording) << diagnostics.Format();
  EXPECT_NEAR(recording->rate_Hz(), 100, 1e-9);
  EXPECT_THAT(recording->channels[0], ElementsAre(-2000, -4000, -6000, -8000, -10000));
}

TEST_F(MatFile, WithoutUnitsSaysWhereTheyGo) {
  Write({MatWriter::Column("time", {0, 1, 2, 3}), MatWriter::Column("force", {1, 2, 3, 4})});
  Diagnostics diagnostics;
  const std::vector<RecordedChannel> wanted = {{.names = {"force"}, .dimension = kForce, .what = "the force"}};
  EXPECT_FALSE(ReadTimeRecording(file_, wanted, diagnostics));
  EXPECT_THAT(diagnostics, Reports(kUnitMissing, 0, {"'force'", "'N'", "'force_unit'"}));
}

TEST_F(MatFile, TellsLengthsThatDiffer) {
  Write({MatWriter::Column("time", {0, 1, 2, 3}), MatWriter::Column("force", {1, 2, 3}),
         MatWriter::Text("force_unit", "N"), MatWriter::Text("time_unit", "s")});
  Diagnostics diagnostics;
  const std::vector<RecordedChannel> wanted = {{.names = {"force"}, .dimension = kForce, .what = "the force"}};
  EXPECT_FALSE(ReadTimeRecording(file_, wanted, diagnostics));
  EXPECT_THAT(diagnostics, Reports(kSamplesDiffer, {"'force'", "3", "4"}));
}

TEST_F(MatFile, RefusesWhatIsNone) {
  EXPECT_THAT(Faults(folder_.Write("run.mat", "time,force\n1,2\n")), Reports(kMatNotReadable));
  EXPECT_THAT(Faults(folder_.Write("run.mat", "")), Reports(kMatNoVector));
  EXPECT_THAT(Faults((folder_.path() / "none.mat").string()), Reports(kFileNotThere));
  Write({MatWriter::Text("comment", "nothing else")});
  EXPECT_THAT(Faults(file_), Reports(kMatNoVector));
}

TEST_F(MatFile, TellsTwoVectorsOfOneName) {
  Write(
      {MatWriter::Column("force", {1, 2}), MatWriter::Struct("run", {{"force", MatWriter::Column(nullptr, {5, 6})}})});
  EXPECT_THAT(Faults(file_), Reports(kMatVectorTwice, {"'force'"}));
}

TEST_F(MatFile, OfVersion4ThatIsCutShortIsNoRecording) {
  {
    MatWriter mat(file_, MAT_FT_MAT4);
    mat.Add(MatWriter::Column("time", std::vector<double>(1000, 1.0)));
    mat.Add(MatWriter::Column("force", std::vector<double>(1000, 1.0)));
  }
  const std::string whole = ReadText(file_);
  // Heads of 20 bytes with names, and columns of 8000: within the second column, its name, its head, the first column.
  for (const std::size_t size : {whole.size() - 1, whole.size() - 4000, whole.size() - 8003, whole.size() - 8010,
                                 std::size_t{4000}, std::size_t{100}}) {
    SCOPED_TRACE(size);
    EXPECT_THAT(Faults(folder_.Write("run.mat", whole.substr(0, size))), Reports(kMatCutShort));
  }
  // The first alone is a file as well.
  Diagnostics diagnostics;
  EXPECT_TRUE(ReadMatFile(folder_.Write("run.mat", whole.substr(0, 20 + 5 + 8000)), diagnostics))
      << diagnostics.Format();
}

/// Bytes of a file of version 5, element by element, for what no program writes.
class RawMat {
 public:
  explicit RawMat(bool is_big_endian = false) : is_big_endian_(is_big_endian) {}

  std::string Uint32(std::uint32_t value) const {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (is_big_endian_) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  std::string Double(double value) const {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (is_big_endian_) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  std::string Doubles(const std::vector<double>& values) const {
    std::string bytes;
    for (const double value : values) bytes += Double(value);
    return Element(9, bytes);
  }

  std::string Element(std::uint32_t type, const std::string& bytes) const {
    return Uint32(type) + Uint32(static_cast<std::uint32_t>(bytes.size())) + bytes +
           std::string((8 - bytes.size() % 8) % 8, '\0');
  }

  /// `kind`: 1 cells, 4 text, 6 doubles.
  std::string Matrix(std::uint32_t kind, std::uint32_t rows, std::uint32_t columns, const std::string& name,
                     const std::string& content) const {
    return Element(14, Element(6, Uint32(kind) + Uint32(0)) + Element(5, Uint32(rows) + Uint32(columns)) +
                           Element(1, name) + content);
  }

  std::string Compressed(const std::string& element) const {
    uLongf length = compressBound(element.size());
    std::string packed(length, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(element.data()),
             element.size());
    packed.resize(length);
    return Uint32(15) + Uint32(static_cast<std::uint32_t>(length)) + packed;
  }

  std::string File(const std::string& elements) const {
    std::string head = "MATLAB 5.0 MAT-file";
    head.resize(124, ' ');
    return head + (is_big_endian_ ? std::string("\1\0MI", 4) : std::string("\0\1IM", 4)) + elements;
  }

 private:
  bool is_big_endian_;
};

class RawMatFile : public MatFile {
 protected:
  std::string Make(const std::string& elements) { return folder_.Write("run.mat", raw_.File(elements)); }

  RawMat raw_;
  std::string force_ = raw_.Matrix(6, 3, 1, "force", raw_.Doubles({1, 2, 3}));
};

TEST_F(RawMatFile, HoldsNumbersOfEitherOrderOfBytes) {
  const RawMat big(true);
  EXPECT_THAT(Read(folder_.Write("run.mat", big.File(big.Matrix(6, 3, 1, "force", big.Doubles({1, 2, 3})))))[0].values,
              ElementsAre(1, 2, 3));
  EXPECT_THAT(Read(Make(force_))[0].values, ElementsAre(1, 2, 3));
}

TEST_F(RawMatFile, HoldsCompressedVariables) {
  EXPECT_THAT(Read(Make(raw_.Compressed(force_)))[0].values, ElementsAre(1, 2, 3));
  const std::string packed = raw_.Compressed(force_);
  EXPECT_THAT(Faults(Make(packed.substr(0, 8) + std::string(packed.size() - 8, 'x'))), Reports(kMatInflate));
}

TEST_F(RawMatFile, HoldsOnlyTheNumbersThatAreThere) {
  EXPECT_THAT(Faults(Make(raw_.Matrix(6, 1, 100000, "force", raw_.Doubles(std::vector<double>(400, 1.0))))),
              Reports(kMatLength, {"'force'", "400", "100000"}));
}

TEST_F(RawMatFile, HoldsOnlyTheCharactersThatAreThere) {
  const std::vector<MatVector> vectors =
      Read(Make(force_ + raw_.Matrix(4, 1, 4000, "force_unit", raw_.Element(16, "N"))));
  EXPECT_EQ(vectors[0].unit, "N");
  EXPECT_THAT(Faults(Make(force_ + raw_.Matrix(4, 1u << 30, 1, "force_unit", raw_.Element(16, "N")))),
              Reports(kMatLength, {"1", "1073741824"}));
  EXPECT_EQ(Read(Make(force_ + raw_.Matrix(4, 0x7FFFFFFF, 0, "note", raw_.Element(16, "")))).size(), 1u);
}

TEST_F(RawMatFile, HoldsOnlyTheCellsThatAreThere) {
  EXPECT_THAT(Faults(Make(force_ + raw_.Matrix(1, 1, 0x7FFFFFFF, "names", ""))), Reports(kMatCutShort));
}

TEST_F(RawMatFile, HasNoCellsWithinCellsWithoutEnd) {
  std::string cell = raw_.Matrix(6, 0, 0, "", raw_.Doubles({}));
  for (int i = 0; i < 10000; ++i) cell = raw_.Matrix(1, 1, 1, "", cell);
  EXPECT_THAT(Faults(Make(force_ + cell)), Reports(kMatDepth));
}

TEST_F(RawMatFile, SaysWhichCharactersItsUnitHas) {
  const std::vector<MatVector> vectors =
      Read(Make(force_ + raw_.Matrix(4, 1, 2, "force_unit", raw_.Element(17, std::string("\xB0\0C\0", 4)))));
  EXPECT_EQ(vectors[0].unit, "\u00B0C");
}

/// A variable of HDF5 with nothing behind its dimensions.
void WriteEmptyHdf5(const std::string& file, hsize_t length) {
  const hsize_t chunk = 1024;
  const hid_t out = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(layout, 1, &chunk);
  const hid_t set = H5Dcreate2(out, "force", H5T_IEEE_F64LE, space, H5P_DEFAULT, layout, H5P_DEFAULT);
  H5Dclose(set);
  H5Pclose(layout);
  H5Sclose(space);
  H5Fclose(out);
}

TEST_F(MatFile, OfVersion73HoldsOnlyTheNumbersThatAreThere) {
  WriteEmptyHdf5(file_, hsize_t{1} << 40);
  EXPECT_THAT(Faults(file_), Reports(kMatStorage, {"'force'", "1099511627776", "0"}));
}

TEST_F(MatFile, OfVersion73ThatIsDamagedLeavesTheTerminalAlone) {
  {
    MatWriter mat(file_, MAT_FT_MAT73);
    mat.Add(MatWriter::Column("force", std::vector<double>(1000, 1.0)));
  }
  std::string bytes = ReadText(file_);
  bytes.resize(bytes.size() / 2);
  testing::internal::CaptureStderr();
  EXPECT_THAT(Faults(folder_.Write("run.mat", bytes)).items(),
              ElementsAre(testing::Field(&Diagnostic::id, testing::StartsWith("mat-"))));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(MatFile, ThatIsCutShortIsNoRecording) {
  Write({MatWriter::Column("force", std::vector<double>(1000, 1.0))});
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(Faults(file_), Reports(kMatCutShort));
}

}  // namespace
}  // namespace fourpost::mat_file_test
