#include "analysis/text_file.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

std::string Fault(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadTextFile(file, diagnostics));
  return diagnostics.Format();
}

TEST(TextFile, IsReadByteForByte) {
  const TemporaryFolder folder;
  const std::string bytes(
      "\xEF\xBB\xBF"
      "a\r\n\0b",
      8);
  Diagnostics diagnostics;
  EXPECT_EQ(ReadTextFile(folder.Write("t.txt", bytes), diagnostics), bytes);
  EXPECT_EQ(diagnostics.Format(), "");
}

TEST(TextFile, MayBeEmpty) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  EXPECT_EQ(ReadTextFile(folder.Write("t.txt", ""), diagnostics), "");
  EXPECT_EQ(diagnostics.Format(), "");
}

TEST(TextFile, ThatIsNotThereIsReported) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "t.txt";
  EXPECT_EQ(Fault(file), file.string() + ": error: cannot be read: No such file or directory");
}

TEST(TextFile, ThatIsAFolderIsReported) {
  const TemporaryFolder folder;
  EXPECT_EQ(Fault(folder.path()), folder.path().string() + ": error: cannot be read: Is a directory");
}

}  // namespace
}  // namespace fourpost
