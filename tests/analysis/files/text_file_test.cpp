#include "analysis/files/text_file.h"

#include <sys/stat.h>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::text_file_test {
namespace {

Diagnostics Fault(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadTextFile(file, diagnostics));
  return diagnostics;
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
  EXPECT_THAT(Fault(file), ReportsOnly(kFileNotThere, 0));
}

TEST(TextFile, ThatIsAFolderIsReported) {
  const TemporaryFolder folder;
  EXPECT_THAT(Fault(folder.path()), ReportsOnly(kFileUnreadable, 0));
}

TEST(TextFile, IsNoPipeAndNoDevice) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(Fault(pipe), Reports(kFileNotRegular));
  EXPECT_THAT(Fault("/dev/zero"), Reports(kFileNotRegular));
}

TEST(TextFile, OfMoreThanAGibibyteIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.Write("t.csv", "");
  std::filesystem::resize_file(file, (std::uintmax_t{1} << 30) + 1);
  EXPECT_THAT(Fault(file), Reports(kFileTooLarge, {"1 GiB"}));
}

}  // namespace
}  // namespace fourpost::text_file_test
