// Fits that are killed, starved and started twice: what they paid for is kept, and in the end the result is the same.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "identify/search/evaluation_store.h"
#include "tests/identify/archive_copy.h"
#include "tests/identify/program.h"
#include "tests/identify/running_program.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kStudy = "studies/landrover110/model2.yaml";

class Resume : public ProgramTest {
 protected:
  Resume() {
    // Some tenths of a second.
    ReplaceIn(kStudy, "band: [0.5 Hz, 12 Hz]", "band: [1.5 Hz, 4 Hz]");
    ReplaceIn(kStudy, "  evaluations: 100\n", "  evaluations: 200\n");
    ReplaceIn(kStudy, "  starts: 4", "  starts: 2");
  }

  static std::string Fit(const std::string& folder, const std::string& study = kStudy) {
    return "fit --no-suggest " + study + " --threads 2 -o " + folder;
  }

  StoredContent ArchiveIn(const std::string& folder) const {
    return ReadStoredContent(folder_ / folder / "archive.sqlite");
  }

  void ExpectSameFiles(const std::string& folder, const std::string& as) const {
    for (const char* file : {"result.json", "vehicle.urdf", "response.csv", "response.svg"})
      EXPECT_EQ(ReadText(folder_ / folder / file), ReadText(folder_ / as / file)) << folder << ' ' << file;
  }

  void ExpectSameResults(const std::string& folder, const std::string& as) const {
    ExpectSameFiles(folder, as);
    EXPECT_EQ(ArchiveIn(folder).digest, ArchiveIn(as).digest) << folder;
  }

  void ExpectPaidOnce(const std::string& folder) const {
    const StoredContent content = ArchiveIn(folder);
    EXPECT_EQ(content.paid, content.evaluations) << folder;
    const auto result = nlohmann::json::parse(ReadText(folder_ / folder / "result.json"));
    EXPECT_EQ(result["evaluations"]["paid"], content.evaluations) << folder;
  }

  /// Returns when the archive has so many, or when the program has ended.
  static void WaitForRows(RunningProgram& program, const fs::path& archive, std::int64_t rows) {
    while (program.IsRunning() && RowsOfCopy(archive) < rows) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  /// As somebody whom permissions hold off, which they do not do with root.
  static std::string Unprivileged() {
    return geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  }
  Outcome RunUnprivileged(const std::string& arguments) const {
    return RunShell(Unprivileged() + "'" + FOURPOST_PROGRAM + "' " + arguments);
  }
  bool CanRunUnprivileged() const {
    fs::permissions(folder_, fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
    return RunUnprivileged("--version").code == 0;
  }

  static void Permit(const fs::path& file, bool write) {
    constexpr fs::perms kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    fs::permissions(file, kWrite, write ? fs::perm_options::add : fs::perm_options::remove);
  }
};

TEST_F(Resume, AfterFiftyKillsGivesTheResultOfAnUninterruptedFitAndPaysForNothingTwice) {
  // A quarter car: little but evaluations.
  const std::string study = "studies/starter/study.yaml";
  ReplaceIn(study, "  evaluations: 100\n", "  evaluations: 1500\n  generations: 1000\n");
  ASSERT_EQ(Run(Fit("whole", study)).code, 0);
  ExpectPaidOnce("whole");
  const std::int64_t all = ArchiveIn("whole").evaluations;

  std::mt19937 engine(7);
  int kills = 0;
  int kills_at_work = 0;
  int logs_left = 0;
  std::int64_t rows_at_kills = 0;
  for (int run = 0; kills < 50; ++run) {
    // Of five kills a run, some of which come too late.
    ASSERT_LT(run, 100);
    const std::string folder = "run" + std::to_string(run);
    const fs::path archive = folder_ / folder / "archive.sqlite";
    for (int i = 0; i < 5; ++i) {
      const std::int64_t rows = RowsOfCopy(archive);
      RunningProgram program(folder_, Fit(folder, study) + " --resume");
      WaitForRows(program, archive,
                  std::uniform_int_distribution<std::int64_t>(std::min(rows, all - 1), all - 1)(engine));
      program.Signal(SIGKILL);
      const int code = program.Wait();
      // 128 + SIGKILL; or it was done before.
      ASSERT_THAT(code, AnyOf(137, 0)) << program.err();
      if (code == 0) break;
      ++kills;
      const fs::path log = archive.string() + "-wal";
      const std::int64_t rows_now = RowsOfCopy(archive);
      rows_at_kills += rows_now;
      // With all evaluations in it the archive is closed, and the results are written.
      if (rows_now == all) continue;
      ++kills_at_work;
      logs_left += fs::exists(log) && fs::file_size(log) > 0;
    }
    const Outcome resumed = Run(Fit(folder, study) + " --resume");
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    ExpectSameResults(folder, "whole");
    ExpectPaidOnce(folder);
  }
  // They were killed at work: neither before the first evaluation nor after the last, on the whole.
  EXPECT_GT(rows_at_kills, kills * all / 20);
  EXPECT_LT(rows_at_kills, kills * all * 19 / 20);
  // And most of them left a log, which the next start took in.
  // How many of them come before the results are written depends on the machine.
  EXPECT_GT(kills_at_work, kills / 5);
  EXPECT_GT(logs_left, kills_at_work / 2);
}

TEST_F(Resume, AfterCtrlCGoesOn) {
  ASSERT_EQ(Run(Fit("whole")).code, 0);
  // So many evaluations that Ctrl-C comes before the last, on any machine.
  const std::string budget = "  evaluations: 200\n";
  const std::string endless = "  evaluations: 100000000\n  generations: 1000000\n";
  ReplaceIn(kStudy, budget, endless);
  {
    RunningProgram program(folder_, Fit("run"));
    WaitForRows(program, folder_ / "run/archive.sqlite", 10);
    program.Signal(SIGINT);
    ASSERT_EQ(program.Wait(), 130) << program.err();
  }
  ReplaceIn(kStudy, endless, budget);
  const Outcome resumed = Run(Fit("run") + " --resume");
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, testing::ContainsRegex("[1-9][0-9]* of [0-9]+ evaluations come from run/archive.sqlite"));
  ExpectSameFiles("run", "whole");
  EXPECT_EQ(ArchiveIn("run").paid, ArchiveIn("run").evaluations);
}

TEST_F(Resume, NeedsItsStudyAndRecordingsAtTheStartOnly) {
  ASSERT_EQ(Run(Fit("whole")).code, 0);
  const std::string study = ReadText(folder_ / kStudy);
  const fs::path recordings = folder_ / fs::path(kStudy).parent_path();
  RunningProgram program(folder_, Fit("run"));
  WaitForRows(program, folder_ / "run/archive.sqlite", 10);
  fs::remove(folder_ / kStudy);
  fs::remove(recordings / "pitch_frf.csv");
  fs::copy_file(recordings / "static.csv", recordings / "bounce_frf.csv", fs::copy_options::overwrite_existing);
  EXPECT_EQ(program.Wait(), 0) << program.err();
  EXPECT_EQ(ReadText(folder_ / "run/study.yaml"), study);
  const auto fitted = [&](const std::string& folder) {
    return nlohmann::json::parse(ReadText(folder_ / folder / "result.json")).at("fitted_files");
  };
  EXPECT_EQ(fitted("run"), fitted("whole"));
  EXPECT_EQ(fitted("run").size(), 2u);
}

TEST_F(Resume, OfAFinishedFitCostsNothingWithOrWithoutTheOption) {
  const Outcome first = Run(Fit("run"));
  const std::string result = ReadText(folder_ / "run/result.json");
  for (const char* option : {" --resume", ""}) {
    const Outcome again = Run(Fit("run") + option);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(ReadText(folder_ / "run/result.json"), result);
    const std::string all = std::to_string(ArchiveIn("run").evaluations);
    EXPECT_THAT(again.err, HasSubstr(all + " of " + all + " evaluations come from"));
  }
  ExpectPaidOnce("run");
}

TEST_F(Resume, ReusesWhatAnotherSeedOrBudgetPaidFor) {
  ASSERT_EQ(Run(Fit("run")).code, 0);
  const std::int64_t before = ArchiveIn("run").evaluations;
  ReplaceIn(kStudy, "  evaluations: 200\n", "  evaluations: 240\n");
  const Outcome longer = Run(Fit("run") + " --resume");
  EXPECT_EQ(longer.code, 0) << longer.err;
  EXPECT_THAT(longer.err, HasSubstr("evaluations come from"));
  EXPECT_GT(ArchiveIn("run").evaluations, before);
  EXPECT_EQ(ArchiveIn("run").paid, ArchiveIn("run").evaluations);
}

TEST_F(Resume, ReusesEvaluationsForAnotherLoss) {
  ReplaceIn(kStudy, "refine: {loss: huber}\n", "");
  ASSERT_EQ(Run(Fit("run")).code, 0);
  const auto before = nlohmann::json::parse(ReadText(folder_ / "run/result.json"));
  EXPECT_EQ(before["refine"]["loss"], "none");
  EXPECT_FALSE(before["refine"].contains("scale"));
  ReplaceIn(kStudy, "search:\n", "refine: {loss: huber, scale: 1}\nsearch:\n");
  const Outcome robust = Run(Fit("run") + " --resume");
  ASSERT_EQ(robust.code, 0) << robust.err;
  EXPECT_THAT(robust.out, HasSubstr(" by huber beyond 1 sd for "));
  // Those of the search at least.
  EXPECT_THAT(robust.err, testing::ContainsRegex("[2-9][0-9][0-9] of [0-9]+ evaluations come from"));
  const auto after = nlohmann::json::parse(ReadText(folder_ / "run/result.json"));
  EXPECT_EQ(after["refine"]["loss"], "huber");
  EXPECT_EQ(after["refine"]["scale"], 1.0);
  EXPECT_GT(after["refine"]["step"], 0);
  EXPECT_LT(after["cost"], before["cost"]);
}

TEST_F(Resume, NamesWhatChangedAndLeavesTheArchive) {
  ASSERT_EQ(Run(Fit("run")).code, 0);
  const std::string digest = ArchiveIn("run").digest;
  const auto expect_refused = [&](const std::string& change) {
    const Outcome outcome = Run(Fit("run") + " --resume");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("cannot resume"));
    EXPECT_THAT(outcome.err, HasSubstr("another state of: " + change + ": undo the change"));
    EXPECT_EQ(ArchiveIn("run").digest, digest);
  };
  ReplaceIn(kStudy, "[1.5 Hz, 4 Hz]", "[1.5 Hz, 3 Hz]");
  expect_refused("the recordings, their channels, the static loads, the band or the window");
  ReplaceIn(kStudy, "[1.5 Hz, 3 Hz]", "[1.5 Hz, 4 Hz]");
  ReplaceIn(kStudy, "  mean: 0.3 mm", "  mean: 0.4 mm");
  expect_refused("the free parameters, the model error or the deadline");
  // Still so when asked again.
  expect_refused("the free parameters, the model error or the deadline");
  ReplaceIn(kStudy, "  mean: 0.4 mm", "  mean: 0.3 mm");
  const fs::path vehicle = "urdf/landrover110_linkage.urdf";
  ReplaceIn(vehicle, "lower=\"1450 kg\"", "lower=\"1451 kg\"");
  expect_refused("the vehicle");

  // Without the option it is fitted anew, beside what was there.
  ASSERT_EQ(Run(Fit("run")).code, 0);
  EXPECT_NE(ArchiveIn("run").digest, digest);
  ReplaceIn(vehicle, "lower=\"1451 kg\"", "lower=\"1450 kg\"");
  const std::int64_t both = ArchiveIn("run").evaluations;
  EXPECT_EQ(Run(Fit("run") + " --resume").code, 0);
  EXPECT_EQ(ArchiveIn("run").evaluations, both);
}

TEST_F(Resume, WithNothingToResumeStartsAndSaysSo) {
  const Outcome outcome = Run(Fit("run") + " --resume");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("there is no run/archive.sqlite to resume from: starting from the beginning"));
  EXPECT_THAT(Run(Fit("run") + " --resume").err, Not(HasSubstr("from the beginning")));
}

TEST_F(Resume, TwoFitsOfOneArchiveAtOnceGiveTheSame) {
  ASSERT_EQ(Run(Fit("whole")).code, 0);
  const auto paid = nlohmann::json::parse(ReadText(folder_ / "whole/result.json"))["evaluations"]["paid"].get<int>();
  const std::string all_restored = std::to_string(paid) + " of " + std::to_string(paid) + " evaluations come from";
  const std::string fit = std::string("'") + FOURPOST_PROGRAM + "' " + Fit("both");
  int overlapping = 0;
  for (int round = 0; round < 20 && overlapping < 3; ++round) {
    fs::remove_all(folder_ / "both");
    const Outcome both = RunShell(fit + " >one.txt 2>one_err.txt & one=$!; " + fit + " >two.txt && wait $one");
    ASSERT_EQ(both.code, 0) << both.err;
    EXPECT_EQ(ReadText(folder_ / "one.txt"), ReadText(folder_ / "two.txt"));
    ExpectSameResults("both", "whole");
    // Else one came after the other.
    overlapping += both.err.find(all_restored) == std::string::npos &&
                   ReadText(folder_ / "one_err.txt").find(all_restored) == std::string::npos;
  }
  EXPECT_GT(overlapping, 0);
}

TEST_F(Resume, AFileThatMayNotGrowEndsTheFitAndKeepsWhatIsThere) {
  ASSERT_EQ(Run(Fit("whole")).code, 0);
  // In blocks of 512 bytes; the largest one at the first transfer of the log into the file.
  for (const int blocks : {1, 200, 2000, 6000}) {
    const std::string folder = "run" + std::to_string(blocks);
    const Outcome starved =
        RunShell("ulimit -f " + std::to_string(blocks) + "; exec '" + FOURPOST_PROGRAM + "' " + Fit(folder));
    EXPECT_EQ(starved.code, 5) << blocks << starved.err;
    EXPECT_THAT(starved.err, HasSubstr("archive.sqlite: ")) << blocks;
    EXPECT_FALSE(fs::exists(folder_ / folder / "result.json"));
    const std::int64_t kept = ArchiveIn(folder).evaluations;
    EXPECT_GE(kept, blocks >= 200 ? 1 : 0) << blocks;
    const Outcome resumed = Run(Fit(folder) + " --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr(kept > 0 ? std::to_string(kept) + " of " : "results: "));
    ExpectSameResults(folder, "whole");
    ExpectPaidOnce(folder);
  }
}

TEST_F(Resume, AFullDiskEndsTheFitAndKeepsWhatIsThere) {
  ASSERT_EQ(Run(Fit("whole")).code, 0);
  for (const int bytes : {2000, 100000, 1000000}) {
    const std::string folder = "run" + std::to_string(bytes);
    const Outcome starved = RunShell("FULL_DISK_BYTES=" + std::to_string(bytes) +
                                     // Else a sanitizer wants to be preloaded first.
                                     " ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" FOURPOST_FULL_DISK "' '" +
                                     FOURPOST_PROGRAM + "' " + Fit(folder));
    EXPECT_EQ(starved.code, 5) << bytes << starved.err;
    EXPECT_THAT(starved.err, HasSubstr("[archive-disk-full]"));
    EXPECT_FALSE(fs::exists(folder_ / folder / "result.json"));
    const std::int64_t kept = ArchiveIn(folder).evaluations;
    EXPECT_GE(kept, bytes >= 100000 ? 1 : 0) << bytes;
    const Outcome resumed = Run(Fit(folder) + " --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr(kept > 0 ? std::to_string(kept) + " of " : "results: "));
    ExpectSameResults(folder, "whole");
    ExpectPaidOnce(folder);
  }
}

TEST_F(Resume, AFolderThatIsReadOnlyEndsTheFitAndKeepsWhatIsThere) {
  if (!CanRunUnprivileged()) GTEST_SKIP() << "permissions hold nobody off here";
  ASSERT_EQ(Run(Fit("run")).code, 0);
  const std::string digest = ArchiveIn("run").digest;
  const std::string result = ReadText(folder_ / "run/result.json");
  Permit(folder_ / "run", false);
  for (const char* option : {"", " --resume", " --seed 9"}) {
    const Outcome refused = RunUnprivileged(Fit("run") + option);
    EXPECT_EQ(refused.code, 5) << refused.err;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("run: error: "), HasSubstr("[folder-not-writable]")));
  }
  // The archive alone.
  Permit(folder_ / "run", true);
  Permit(folder_ / "run/archive.sqlite", false);
  const Outcome refused = RunUnprivileged(Fit("run") + " --seed 9");
  EXPECT_EQ(refused.code, 5) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("run/archive.sqlite: "));
  Permit(folder_ / "run/archive.sqlite", true);
  EXPECT_EQ(ArchiveIn("run").digest, digest);
  EXPECT_EQ(ReadText(folder_ / "run/result.json"), result);
}

TEST_F(Resume, EvaluationsBeyondTheDeadlineAreCountedAndNamed) {
  ReplaceIn(kStudy, "  evaluations: 200\n", "  evaluations: 200\n  deadline: 0.001 ms\n");
  for (int round = 0; round < 2; ++round) {
    const Outcome outcome = Run(Fit("run"));
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("fit all_failed: every evaluation failed: 201 timed out (took longer than "));
    EXPECT_FALSE(fs::exists(folder_ / "run/result.json"));
    // Those of the search, and the look at what the data can tell.
    EXPECT_EQ(ArchiveIn("run").evaluations, 201);
  }
}

TEST_F(Resume, ComparedMethodsShareAnArchiveAndTheCountsDoNot) {
  const std::string compare =
      std::string("compare ") + kStudy + " --methods dvhde,thesis,gb,bfgs --runs 2 --threads 2 --json";
  const Outcome without = Run(compare);
  ASSERT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(Run(compare + " --archive shared.sqlite").out, without.out);
  const StoredContent content = ReadStoredContent(folder_ / "shared.sqlite");
  EXPECT_GT(content.evaluations, 300);
  // However many runs asked at once.
  EXPECT_EQ(content.paid, content.evaluations);
  EXPECT_EQ(Run(compare + " --archive shared.sqlite").out, without.out);
  EXPECT_EQ(ReadStoredContent(folder_ / "shared.sqlite").digest, content.digest);
}

}  // namespace
}  // namespace fourpost
