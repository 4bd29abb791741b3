// What the fuzzer has found stays read: its corpus, the broken files and the shipped vehicles, without a fuzzer.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fuzz/vehicle_fuzzer.h"
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

class FuzzedReader : public ::testing::TestWithParam<const char*> {};

TEST_P(FuzzedReader, StandsEveryFile) {
  const std::vector<fs::path> files = FilesIn(kSource / GetParam());
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    const std::string text = fourpost::ReadText(file);
    EXPECT_NO_THROW(LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(text.data()), text.size())) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzedReader, ::testing::Values("tests/fuzz/corpus", "tests/data/broken", "urdf"),
                         [](const auto& test) {
                           const std::string folder = test.param;
                           return folder.substr(folder.rfind('/') + 1);
                         });

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
