// What the fuzzers have found stays read: their corpora, the broken files and the shipped vehicles, without a fuzzer.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fuzz/fuzz_target.h"
#include "tests/temporary_folder.h"
#include "vehicles/tags/tag_table.h"

namespace {

namespace fs = std::filesystem;

const fs::path kSource = FOURPOST_SOURCE_DIR;

std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

struct Fuzzed {
  const char* name;
  void (*fuzz)(const std::string&);
  std::vector<const char*> folders;
};

class FuzzedReader : public ::testing::TestWithParam<Fuzzed> {};

TEST_P(FuzzedReader, StandsEveryFile) {
  for (const char* folder : GetParam().folders) {
    const std::vector<fs::path> files = FilesIn(kSource / folder);
    EXPECT_FALSE(files.empty());
    for (const fs::path& file : files) EXPECT_NO_THROW(GetParam().fuzz(fourpost::ReadText(file))) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, FuzzedReader,
    ::testing::Values(
        Fuzzed{"Vehicle", fourpost::FuzzVehicle, {"tests/fuzz/corpus/vehicle", "tests/data/broken", "urdf"}},
        Fuzzed{"Mat", fourpost::FuzzMat, {"tests/fuzz/corpus/mat"}},
        Fuzzed{"Table", fourpost::FuzzTable, {"tests/fuzz/corpus/table"}},
        Fuzzed{"Curve", fourpost::FuzzCurve, {"tests/fuzz/corpus/curve", "tests/fuzz/corpus/table"}},
        Fuzzed{"Chrono", fourpost::FuzzChrono, {"tests/fuzz/corpus/chrono"}},
        Fuzzed{"Rpc", fourpost::FuzzRpc, {"tests/fuzz/corpus/rpc"}},
        Fuzzed{"Universal", fourpost::FuzzUniversal, {"tests/fuzz/corpus/universal", "tests/data/recordings"}},
        Fuzzed{"Tdms", fourpost::FuzzTdms, {"tests/fuzz/corpus/tdms"}},
        Fuzzed{"Mdf", fourpost::FuzzMdf, {"tests/fuzz/corpus/mdf"}},
        Fuzzed{"Lvm", fourpost::FuzzLvm, {"tests/fuzz/corpus/lvm"}},
        Fuzzed{"Study", fourpost::FuzzStudy, {"tests/fuzz/corpus/study"}},
        Fuzzed{"Result", fourpost::FuzzResult, {"tests/fuzz/corpus/result"}},
        Fuzzed{"Archive", fourpost::FuzzArchive, {"tests/fuzz/corpus/archive"}}),
    [](const auto& test) { return test.param.name; });

TEST(FuzzDictionary, KnowsEveryTagAndAttribute) {
  const std::string dictionary = fourpost::ReadText(kSource / "tests/fuzz/vehicle.dict");
  const auto expect = [&](const std::string& line) {
    EXPECT_NE(dictionary.find(line + '\n'), std::string::npos) << "add to tests/fuzz/vehicle.dict: " << line;
  };
  for (const auto& tags : {fourpost::OwnTags(), fourpost::UrdfTags()})
    for (const fourpost::TagRule& tag : tags) {
      expect("\"<" + std::string(tag.Name()) + '"');
      for (const fourpost::AttributeRule& attribute : tag.attributes)
        expect("\" " + std::string(attribute.name) + "=\\\"\"");
    }
}

}  // namespace
