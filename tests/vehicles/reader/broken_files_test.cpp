// Each file of tests/data/broken has one fault, and says in its first lines what must be found in it:
//   <!-- expect: LINE: ID: NAME OR NUMBER; ANOTHER -->
// LINE 0 stands for the file as a whole. A new case is a new file.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::broken_files_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(FOURPOST_SOURCE_DIR) / "tests/data/broken";

std::vector<std::string> FileNames() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == ".urdf") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The expectations of the first lines, as "LINE: ID: WORD; WORD".
std::vector<std::string> Expected(std::string_view text) {
  constexpr std::string_view kBegin = "<!-- expect: ";
  constexpr std::string_view kEnd = " -->";
  std::vector<std::string> expected;
  while (text.starts_with(kBegin)) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!line.ends_with(kEnd)) break;
    expected.emplace_back(line.substr(kBegin.size(), line.size() - kBegin.size() - kEnd.size()));
    text.remove_prefix(line.size() + 1);
  }
  return expected;
}

std::string Shown(const Diagnostic& found) {
  return std::to_string(found.place.line) + ": " + found.id + ": " + found.message;
}

/// Whether the finding is of this line and kind, and its message names each of the words.
bool Meets(const Diagnostic& found, const std::string& expected) {
  const std::string head = std::to_string(found.place.line) + ": " + found.id;
  if (expected == head) return true;
  if (!expected.starts_with(head + ": ")) return false;
  for (std::size_t from = head.size() + 2; from < expected.size();) {
    const std::size_t end = std::min(expected.find("; ", from), expected.size());
    if (found.message.find(expected.substr(from, end - from)) == std::string::npos) return false;
    from = end + 2;
  }
  return true;
}

/// What reading the file and making its multibody system finds.
Diagnostics Findings(const fs::path& file) {
  Diagnostics diagnostics;
  try {
    const std::optional<Vehicle> vehicle = ReadVehicle(file, diagnostics);
    if (vehicle) CondensedVehicle{*vehicle};
  } catch (const FaultyInput& fault) {
    for (const Diagnostic& item : fault.diagnostics().items()) diagnostics.Add(item);
  }
  return diagnostics;
}

class BrokenFiles : public ::testing::TestWithParam<std::string> {};

TEST_P(BrokenFiles, AreToldByTheirFault) {
  const fs::path file = kFolder / (GetParam() + ".urdf");
  std::vector<std::string> expected = Expected(ReadText(file));
  EXPECT_FALSE(expected.empty()) << "the file does not say what to expect";
  const Diagnostics findings = Findings(file);
  for (const Diagnostic& found : findings.items()) {
    EXPECT_EQ(found.place.file, file.string());
    const auto met = std::find_if(expected.begin(), expected.end(),
                                  [&](const std::string& expectation) { return Meets(found, expectation); });
    if (met == expected.end()) ADD_FAILURE() << "not expected: " << Shown(found);
    else expected.erase(met);
  }
  for (const std::string& missing : expected) ADD_FAILURE() << "not found: " << missing;
}

INSTANTIATE_TEST_SUITE_P(All, BrokenFiles, ::testing::ValuesIn(FileNames()),
                         [](const auto& test) { return test.param; });

// As many as there were when this was written: a case that is lost, or a folder that is not found, must fail.
TEST(BrokenFilesFolder, IsNotDepleted) { EXPECT_GE(FileNames().size(), 257U); }

}  // namespace
}  // namespace fourpost::broken_files_test
