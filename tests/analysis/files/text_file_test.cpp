#include "analysis/files/text_file.h"

#include <sys/stat.h>

#include <gmock/gmock.h>

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

TEST(TextFile, IsNoPipeAndNoDevice) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(Fault(pipe), testing::HasSubstr("is a pipe, not a file; write what it holds to a file, and give that"));
  EXPECT_THAT(Fault("/dev/zero"), testing::HasSubstr("is a device, not a file"));
}

TEST(TextFile, OfMoreThanAGibibyteIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.Write("t.csv", "");
  std::filesystem::resize_file(file, (std::uintmax_t{1} << 30) + 1);
  EXPECT_THAT(Fault(file), testing::HasSubstr("is larger than 1 GiB; give a part of it, or a lower rate"));
}

}  // namespace
}  // namespace fourpost
