#include "analysis/files/output_folder.h"

#include <functional>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::output_folder_test {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::set<std::string> Names(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// Of an action that must fail.
Diagnostics OutputErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const OutputError& error) {
    return error.diagnostics();
  }
  ADD_FAILURE() << "no OutputError";
  return {};
}

OutputFolder TwoFiles(const fs::path& folder) {
  OutputFolder output(folder);
  output.Add("result.json", "{}\n");
  output.Add("fit.csv", "a\n1\n");
  return output;
}

TEST(OutputFolder, WritesItsFilesIntoANewFolder) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path() / "runs" / "first";
  TwoFiles(folder).Commit();
  EXPECT_THAT(Names(folder), UnorderedElementsAre("result.json", "fit.csv"));
  EXPECT_EQ(ReadText(folder / "result.json"), "{}\n");
  EXPECT_EQ(ReadText(folder / "fit.csv"), "a\n1\n");
}

TEST(OutputFolder, WritesIntoAnEmptyFolder) {
  const TemporaryFolder temporary;
  TwoFiles(temporary.path()).Commit();
  EXPECT_THAT(Names(temporary.path()), UnorderedElementsAre("result.json", "fit.csv"));
}

TEST(OutputFolder, MayEndWithASlash) {
  const TemporaryFolder temporary;
  TwoFiles(temporary.path() / "new/").Commit();
  EXPECT_THAT(Names(temporary.path() / "new"), UnorderedElementsAre("result.json", "fit.csv"));
}

TEST(OutputFolder, ReplacesTheFilesOfAnEarlierRunAndKeepsOthers) {
  const TemporaryFolder temporary;
  temporary.Write("result.json", "old");
  temporary.Write("notes.txt", "mine");
  TwoFiles(temporary.path()).Commit();
  EXPECT_EQ(ReadText(temporary.path() / "result.json"), "{}\n");
  EXPECT_EQ(ReadText(temporary.path() / "notes.txt"), "mine");
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
  const TemporaryFolder temporary;
  TwoFiles(temporary.path() / "runs" / "first");
  EXPECT_THAT(Names(temporary.path()), IsEmpty());
}

TEST(OutputFolder, WritesAllBytesOfALargeFile) {
  const TemporaryFolder temporary;
  const std::string content(3'000'000, '\0');
  OutputFolder output(temporary.path());
  output.Add("result.json", content);
  output.Commit();
  EXPECT_EQ(ReadText(temporary.path() / "result.json"), content);
}

TEST(OutputFolder, RefusesFilesThatAreNotOfAnEarlierRun) {
  const TemporaryFolder temporary;
  temporary.Write("thesis.doc", "years of work");
  const Diagnostics found = OutputErrorOf([&] { OutputFolder output(temporary.path()); });
  EXPECT_THAT(found, ReportsOnly(kFolderHoldsFiles, 0, {"result.json"}));
  EXPECT_EQ(found.items().at(0).place.file, temporary.path().string());
}

TEST(OutputFolder, RefusesTheNameOfAFile) {
  const TemporaryFolder temporary;
  const fs::path file = temporary.Write("run", "");
  EXPECT_THAT(OutputErrorOf([&] { OutputFolder output(file); }), ReportsOnly(kFolderIsAFile, 0));
}

TEST(OutputFolder, IsTakenForOursByTheTraceOfARun) {
  const TemporaryFolder temporary;
  temporary.Write("archive.sqlite", "");
  EXPECT_THROW(OutputFolder output(temporary.path()), OutputError);
  EXPECT_THROW(OutputFolder(temporary.path(), "another"), OutputError);
  EXPECT_NO_THROW(OutputFolder(temporary.path(), "archive.sqlite"));
  // Created at once, for the trace.
  OutputFolder(temporary.path() / "new", "archive.sqlite");
  EXPECT_TRUE(fs::is_empty(temporary.path() / "new"));
}

TEST(OutputFolder, WithdrawnIsAsItWasBefore) {
  const TemporaryFolder temporary;
  OutputFolder created(temporary.path() / "runs" / "first", "archive.sqlite");
  temporary.Write("runs/first/archive.sqlite", "");
  created.Withdraw();
  EXPECT_THAT(Names(temporary.path()), IsEmpty());

  OutputFolder empty(temporary.path(), "archive.sqlite");
  temporary.Write("archive.sqlite", "");
  empty.Withdraw();
  EXPECT_THAT(Names(temporary.path()), IsEmpty());

  temporary.Write("archive.sqlite", "paid for");
  OutputFolder(temporary.path(), "archive.sqlite").Withdraw();
  EXPECT_EQ(ReadText(temporary.path() / "archive.sqlite"), "paid for");
}

TEST(OutputFolder, IsEmptyToOneThatWasKilledWhileItLooked) {
  const TemporaryFolder temporary;
  temporary.Write(".fourpost.partial", "probe");
  TwoFiles(temporary.path()).Commit();
  EXPECT_TRUE(fs::exists(temporary.path() / "result.json"));
}

TEST(OutputFolder, OfTwoAtOnceIsThatOfOneOfThem) {
  const TemporaryFolder temporary;
  const std::string long_text(100000, 'x');
  const auto commit = [&](const std::string& mark) {
    for (int i = 0; i < 50; ++i) {
      OutputFolder output(temporary.path() / "run");
      output.Add("table.csv", mark + long_text);
      output.Add("result.json", mark);
      output.Commit();
    }
  };
  fs::create_directory(temporary.path() / "run");
  temporary.Write("run/result.json", "of an earlier run");
  std::thread other([&] { commit("a"); });
  commit("b");
  other.join();
  EXPECT_EQ(ReadText(temporary.path() / "run/table.csv"), ReadText(temporary.path() / "run/result.json") + long_text);
}

TEST(OutputFolder, RefusesAPathThroughAFile) {
  const TemporaryFolder temporary;
  const fs::path file = temporary.Write("run", "");
  const Diagnostics found = OutputErrorOf([&] { OutputFolder output(file / "first"); });
  EXPECT_THAT(found, ReportsOnly(kFolderIsAFile, 0));
  EXPECT_EQ(found.items().at(0).place.file, file.string());
}

TEST(OutputFolder, RefusesALinkToNothing) {
  const TemporaryFolder temporary;
  const fs::path link = temporary.path() / "run";
  fs::create_symlink(temporary.path() / "nothing", link);
  EXPECT_THAT(OutputErrorOf([&] { OutputFolder output(link); }), ReportsOnly(kFolderIsAFile, 0));
}

TEST(OutputFolder, RefusesANameThatTheSystemCannotTake) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path() / std::string(300, 'x');
  EXPECT_THAT(OutputErrorOf([&] { OutputFolder output(folder); }),
              ReportsOnly(kFolderNotWritable, 0, {"File name too long"}));
}

TEST(OutputFolder, RefusesAnEmptyName) {
  EXPECT_THAT(OutputErrorOf([] { OutputFolder output(""); }), ReportsOnly(kFolderNameless, 0));
}

TEST(OutputFolder, RefusesAPlaceThatCannotBeWrittenTo) {
  // Nobody, not even root, can create files there.
  EXPECT_THAT(OutputErrorOf([] { OutputFolder output("/proc/fourpost"); }),
              ReportsOnly(kFolderTakesNoFolder, 0, {"/proc"}));
}

TEST(OutputFolder, IsUntouchedWithAFolderInTheWayOfAFile) {
  const TemporaryFolder temporary;
  temporary.Write("result.json", "old");
  fs::create_directory(temporary.path() / "zeta.csv");
  OutputFolder output = TwoFiles(temporary.path());
  output.Add("zeta.csv", "1\n");
  EXPECT_THAT(OutputErrorOf([&] { output.Commit(); }),
              ReportsOnly(kResultsNotWritten, 0, {"zeta.csv: Is a directory"}));
  EXPECT_THAT(Names(temporary.path()), UnorderedElementsAre("result.json", "zeta.csv"));
  EXPECT_EQ(ReadText(temporary.path() / "result.json"), "old");
}

TEST(OutputFolder, IsUntouchedWhenTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const TemporaryFolder temporary;
  temporary.Write("result.json", "old");
  OutputFolder output = TwoFiles(temporary.path());
  // The file that is written goes to the device that is always full.
  fs::create_symlink("/dev/full", temporary.path() / "result.json.partial");
  EXPECT_THAT(OutputErrorOf([&] { output.Commit(); }),
              ReportsOnly(kDiskFull, 0, {"result.json.partial: No space left on device"}));
  EXPECT_THAT(Names(temporary.path()), UnorderedElementsAre("result.json"));
  EXPECT_EQ(ReadText(temporary.path() / "result.json"), "old");
}

TEST(OutputFolder, RemovesTheFoldersItCreatedForNothing) {
  const TemporaryFolder temporary;
  OutputFolder output = TwoFiles(temporary.path() / "runs" / "first");
  // Longer than a file system takes, once ".partial" is added.
  output.Add(std::string(250, 'x'), "");
  EXPECT_THROW(output.Commit(), OutputError);
  EXPECT_THAT(Names(temporary.path()), IsEmpty());
}

TEST(OutputFolder, TakesOnlyNamesOfFilesWithinIt) {
  const TemporaryFolder temporary;
  OutputFolder output(temporary.path());
  for (const char* name : {"", ".", "..", "a/b", "/a", "a/"})
    EXPECT_THROW(output.Add(name, ""), std::invalid_argument) << name;
}

TEST(OutputFolder, TakesANameOnce) {
  const TemporaryFolder temporary;
  OutputFolder output(temporary.path());
  output.Add("fit.csv", "");
  EXPECT_THROW(output.Add("fit.csv", ""), std::invalid_argument);
}

TEST(OutputFolder, NeedsAResult) {
  const TemporaryFolder temporary;
  OutputFolder output(temporary.path() / "run");
  output.Add("fit.csv", "");
  EXPECT_THROW(output.Commit(), std::logic_error);
  EXPECT_THAT(Names(temporary.path()), IsEmpty());
}

}  // namespace
}  // namespace fourpost::output_folder_test
