#include "analysis/mat_file.h"

#include <fstream>

#include <gmock/gmock.h>

#include "analysis/time_recording.h"
#include "tests/analysis/mat_writer.h"
#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<MatVector> Read(const std::string& file) {
  Diagnostics diagnostics;
  std::optional<std::vector<MatVector>> vectors = ReadMatFile(file, diagnostics);
  if (!vectors) throw std::runtime_error(diagnostics.Format());
  return *vectors;
}

std::string Faults(const std::string& file) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadMatFile(file, diagnostics));
  return diagnostics.Format();
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
  EXPECT_THAT(
      diagnostics.Format(),
      HasSubstr("run.mat: error: column 'force', the force, has no unit; write that of a force such as 'N' as a "
                "text 'force_unit' in the file, or name it in the study: {channel: force, unit: N}"));
}

TEST_F(MatFile, TellsLengthsThatDiffer) {
  Write({MatWriter::Column("time", {0, 1, 2, 3}), MatWriter::Column("force", {1, 2, 3}),
         MatWriter::Text("force_unit", "N"), MatWriter::Text("time_unit", "s")});
  Diagnostics diagnostics;
  const std::vector<RecordedChannel> wanted = {{.names = {"force"}, .dimension = kForce, .what = "the force"}};
  EXPECT_FALSE(ReadTimeRecording(file_, wanted, diagnostics));
  EXPECT_THAT(diagnostics.Format(), HasSubstr("column 'force' has 3 samples, the times are 4"));
}

TEST_F(MatFile, RefusesWhatIsNone) {
  EXPECT_THAT(Faults(folder_.Write("run.mat", "time,force\n1,2\n")), HasSubstr("is no MAT file"));
  EXPECT_THAT(Faults(folder_.Write("run.mat", "")), HasSubstr("holds no vector of real numbers"));
  EXPECT_THAT(Faults((folder_.path() / "none.mat").string()), HasSubstr("cannot be read"));
  Write({MatWriter::Text("comment", "nothing else")});
  EXPECT_THAT(Faults(file_), HasSubstr("holds no vector of real numbers"));
}

TEST_F(MatFile, TellsTwoVectorsOfOneName) {
  Write(
      {MatWriter::Column("force", {1, 2}), MatWriter::Struct("run", {{"force", MatWriter::Column(nullptr, {5, 6})}})});
  EXPECT_THAT(Faults(file_), HasSubstr("holds two vectors called 'force'"));
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
    EXPECT_THAT(Faults(folder_.Write("run.mat", whole.substr(0, size))),
                HasSubstr("is cut short; save or copy it again"));
  }
  // The first alone is a file as well.
  Diagnostics diagnostics;
  EXPECT_TRUE(ReadMatFile(folder_.Write("run.mat", whole.substr(0, 20 + 5 + 8000)), diagnostics))
      << diagnostics.Format();
}

TEST_F(MatFile, ThatIsCutShortIsNoRecording) {
  Write({MatWriter::Column("force", std::vector<double>(1000, 1.0))});
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(Faults(file_), HasSubstr("is cut short; save or copy it again"));
}

}  // namespace
}  // namespace fourpost
