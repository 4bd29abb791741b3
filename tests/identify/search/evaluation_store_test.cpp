#include "identify/search/evaluation_store.h"

#include <sqlite3.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/output_folder.h"
#include "identify/search/sqlite_database.h"
#include "tests/temporary_folder.h"

namespace fourpost::evaluation_store_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const EvaluationContext kContext = {.vehicle = "car", .data = "rig", .settings = "band", .version = "1"};

Evaluation Residuals(const std::vector<double>& numbers) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  return evaluation;
}

Eigen::VectorXd At(double value) { return Eigen::VectorXd::Constant(1, value); }

class EvaluationStoreTest : public testing::Test {
 protected:
  std::string OutputErrorOf(const std::filesystem::path& file) const {
    try {
      const EvaluationStore store(file, kContext);
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "run/archive.sqlite";
};

TEST_F(EvaluationStoreTest, KeepsResidualsToTheLastBit) {
  const Evaluation odd =
      Residuals({1.0 / 3, -0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()});
  EvaluationStore(file_, kContext).Put(At(0.1), odd);
  const std::optional<Evaluation> found = EvaluationStore(file_, kContext).Find(At(0.1));
  ASSERT_TRUE(found && found->ok());
  ASSERT_EQ(found->residuals.size(), 4);
  EXPECT_EQ(std::memcmp(found->residuals.data(), odd.residuals.data(), 4 * sizeof(double)), 0);
}

TEST_F(EvaluationStoreTest, KeepsFailuresWithTheirCauseAndWords) {
  {
    EvaluationStore store(file_, kContext);
    store.Put(At(1), Failed(Failure::kTimedOut, "took \"longer\" than 10 s\n\xc3\xa4"));
    store.Put(At(2), Infeasible(1.0 / 3, "no vehicle"));
    for (const Failure failure : {Failure::kNotFinite, Failure::kException, Failure::kNotConverged, Failure::kTimedOut,
                                  Failure::kInfeasible, Failure::kWrongSize})
      store.Put(At(10 + static_cast<int>(failure)), Failed(failure, ""));
  }
  const EvaluationStore store(file_, kContext);
  EXPECT_EQ(store.Find(At(1))->detail, "took \"longer\" than 10 s\n\xc3\xa4");
  EXPECT_EQ(store.Find(At(1))->failure, Failure::kTimedOut);
  EXPECT_EQ(store.Find(At(2))->violation, 1.0 / 3);
  for (const Failure failure : {Failure::kNotFinite, Failure::kException, Failure::kNotConverged, Failure::kTimedOut,
                                Failure::kInfeasible, Failure::kWrongSize})
    EXPECT_EQ(store.Find(At(10 + static_cast<int>(failure)))->failure, failure);
}

TEST_F(EvaluationStoreTest, TellsValuesApartByTheirBits) {
  EvaluationStore store(file_, kContext);
  store.Put(At(1), Residuals({1}));
  EXPECT_TRUE(store.Find(At(1)));
  EXPECT_FALSE(store.Find(At(std::nextafter(1.0, 2.0))));
  EXPECT_FALSE(store.Find(Eigen::Vector2d(1, 1)));
}

TEST_F(EvaluationStoreTest, UsesNoOtherContextAndKeepsIt) {
  EvaluationStore(file_, kContext).Put(At(1), Residuals({1}));
  EvaluationContext other = kContext;
  other.version = "2";
  {
    EvaluationStore store(file_, other);
    EXPECT_FALSE(store.Find(At(1)));
    store.Put(At(1), Residuals({2}));
  }
  EXPECT_EQ(EvaluationStore(file_, kContext).Find(At(1))->residuals[0], 1);
  EXPECT_EQ(ReadStoredContent(file_).evaluations, 2);
}

TEST_F(EvaluationStoreTest, NamesWhatChangedSinceItWasUsedLast) {
  EXPECT_THAT(ChangedParts(file_, kContext), IsEmpty());
  EvaluationContext other = kContext;
  other.settings = "another";
  { const EvaluationStore store(file_, other); }
  EXPECT_THAT(ChangedParts(file_, kContext), ElementsAre("settings"));
  EvaluationContext third = kContext;
  third.vehicle = "bus";
  third.data = "road";
  third.version = "2";
  { const EvaluationStore store(file_, third); }
  EXPECT_THAT(ChangedParts(file_, kContext), ElementsAre("vehicle", "data", "version"));
  { const EvaluationStore store(file_, other); }
  EXPECT_THAT(ChangedParts(file_, kContext), ElementsAre("settings"));
  // What it holds may be gone on with, whatever came after.
  EXPECT_THAT(ChangedParts(file_, third), IsEmpty());
}

TEST_F(EvaluationStoreTest, GivesTheFirstOfTwoAndCountsBoth) {
  EvaluationStore here(file_, kContext);
  EvaluationStore there(file_, kContext);
  EXPECT_EQ(here.Put(At(1), Residuals({1})).residuals[0], 1);
  EXPECT_EQ(there.Put(At(1), Residuals({2})).residuals[0], 1);
  EXPECT_EQ(here.Find(At(1))->residuals[0], 1);
  EXPECT_EQ(ReadStoredContent(file_).evaluations, 1);
  EXPECT_EQ(ReadStoredContent(file_).paid, 2);
}

TEST_F(EvaluationStoreTest, DigestIsThatOfTheContentInWhicheverOrder) {
  const std::filesystem::path turned = folder_.path() / "turned.sqlite";
  for (int i = 0; i < 20; ++i) {
    EvaluationStore(file_, kContext).Put(At(i), Residuals({1.0 * i}));
    EvaluationStore(turned, kContext).Put(At(19 - i), Residuals({19.0 - i}));
  }
  EXPECT_EQ(ReadStoredContent(file_).digest, ReadStoredContent(turned).digest);
  EvaluationStore(turned, kContext).Put(At(20), Residuals({20}));
  EXPECT_NE(ReadStoredContent(file_).digest, ReadStoredContent(turned).digest);
  EvaluationStore(file_, kContext).Put(At(20), Residuals({20.5}));
  EXPECT_NE(ReadStoredContent(file_).digest, ReadStoredContent(turned).digest);
}

TEST_F(EvaluationStoreTest, ServesSeveralThreadsAndSeveralConnections) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      EvaluationStore store(file_, kContext);
      for (int i = 0; i < 200; ++i)
        if (!store.Find(At(i))) store.Put(At(i), Residuals({1.0 * i, 2}));
    });
  for (std::thread& thread : threads) thread.join();
  const EvaluationStore store(file_, kContext);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(store.Find(At(i))->residuals[0], i);
  EXPECT_EQ(ReadStoredContent(file_).evaluations, 200);
}

TEST_F(EvaluationStoreTest, LeavesAFileThatIsNotItsOwnAsItIs) {
  const std::string text(5000, 'x');
  const std::filesystem::path file = folder_.Write("archive.sqlite", text);
  EXPECT_THAT(OutputErrorOf(file), HasSubstr("[archive-foreign]"));
  EXPECT_THROW(ChangedParts(file, kContext), OutputError);
  EXPECT_EQ(ReadText(file), text);
}

TEST_F(EvaluationStoreTest, LeavesAnotherProgramsDatabaseAsItIs) {
  const std::filesystem::path file = folder_.path() / "notes.sqlite";
  const std::filesystem::path log = folder_.path() / "notes.sqlite-wal";
  // Not even their layout's number tells them apart; part of it is in a log, which opening would take in.
  const Database theirs(file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  theirs.Execute("CREATE TABLE note (text); PRAGMA user_version = 1; PRAGMA journal_mode = WAL");
  theirs.Execute("INSERT INTO note VALUES ('years of work')");
  const std::filesystem::path copy = folder_.path() / "copy.sqlite";
  std::filesystem::copy_file(file, copy);
  std::filesystem::copy_file(log, folder_.path() / "copy.sqlite-wal");
  EXPECT_THAT(OutputErrorOf(copy), testing::AllOf(HasSubstr("copy.sqlite: "), HasSubstr("[archive-foreign]")));
  EXPECT_THROW(ChangedParts(copy, kContext), OutputError);
  EXPECT_THROW(ReadStoredContent(copy), OutputError);
  EXPECT_EQ(ReadText(copy), ReadText(file));
  EXPECT_EQ(ReadText(folder_.path() / "copy.sqlite-wal"), ReadText(log));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "copy.sqlite-shm"));
}

TEST_F(EvaluationStoreTest, RefusesALayoutThatItDoesNotKnow) {
  { const EvaluationStore store(file_, kContext); }
  Database(file_, SQLITE_OPEN_READWRITE).Execute("PRAGMA user_version = 3");
  EXPECT_THAT(OutputErrorOf(file_),
              testing::AllOf(HasSubstr("layout 3,"), HasSubstr("up to 2:"), HasSubstr("[archive-layout]")));
}

TEST_F(EvaluationStoreTest, KeepsWhatVersion010Stored) {
  EvaluationContext old = kContext;
  old.version = "0.1.0";
  EvaluationStore(file_, old).Put(At(1), Residuals({1}));
  Database(file_, SQLITE_OPEN_READWRITE)
      .Execute("ALTER TABLE evaluation DROP COLUMN checksum; PRAGMA user_version = 1");
  EXPECT_THAT(ChangedParts(file_, kContext), ElementsAre("version"));
  EvaluationStore(file_, kContext).Put(At(1), Residuals({2}));
  EXPECT_EQ(EvaluationStore(file_, kContext).Find(At(1))->residuals[0], 2);
  EXPECT_EQ(ReadStoredContent(file_).evaluations, 2);
}

TEST_F(EvaluationStoreTest, EvaluatesAnewWhatIsDamaged) {
  const std::string damages[] = {"residuals = x'00000000000000400000000000000040'",
                                 "residuals = x'0000'",
                                 "residuals = NULL",
                                 "residuals = x'000000000000F87F0000000000000040'",
                                 "failure = 'exception'",
                                 "checksum = NULL",
                                 "parameters = x'000000000000F03F'"};
  for (const std::string& damage : damages) {
    SCOPED_TRACE(damage);
    std::filesystem::remove_all(file_.parent_path());
    EvaluationStore(file_, kContext).Put(At(2), Residuals({1, 2}));
    Database(file_, SQLITE_OPEN_READWRITE).Execute(("UPDATE evaluation SET " + damage).c_str());
    EvaluationStore store(file_, kContext);
    const double value = damage.starts_with("parameters") ? 1 : 2;
    const auto evaluate = [] { return Residuals({1, 2}); };
    EXPECT_FALSE(store.FindOrEvaluate(At(value), evaluate).was_stored);
    EXPECT_EQ(store.damaged(), 1u);
    const EvaluationStore::Answer again = store.FindOrEvaluate(At(value), evaluate);
    EXPECT_TRUE(again.was_stored);
    EXPECT_THAT(again.evaluation.residuals, ElementsAre(1, 2));
    EXPECT_EQ(store.damaged(), 1u);
  }
}

TEST_F(EvaluationStoreTest, EvaluatesAnewAFailureThatIsDamaged) {
  EvaluationStore(file_, kContext).Put(At(2), Infeasible(0.5, "no vehicle"));
  Database(file_, SQLITE_OPEN_READWRITE).Execute("UPDATE evaluation SET violation = 0.25");
  EvaluationStore store(file_, kContext);
  EXPECT_FALSE(store.Find(At(2)));
  EXPECT_EQ(store.damaged(), 1u);
}

TEST_F(EvaluationStoreTest, IsNoPipe) {
  const std::filesystem::path pipe = folder_.path() / "archive.sqlite";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(OutputErrorOf(pipe), testing::AllOf(HasSubstr("archive.sqlite: "), HasSubstr("[archive-not-a-file]")));
  EXPECT_THROW(ChangedParts(pipe, kContext), OutputError);
}

TEST_F(EvaluationStoreTest, ThreadsThatAskAtOncePayOnce) {
  EvaluationStore store(file_, kContext);
  std::atomic<int> evaluated = 0;
  std::atomic<int> found = 0;
  const auto evaluate = [&] {
    ++evaluated;
    // So that the others come meanwhile.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return Residuals({1});
  };
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&] { found += store.FindOrEvaluate(At(1), evaluate).was_stored; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(evaluated, 1);
  EXPECT_EQ(found, 3);
  EXPECT_EQ(ReadStoredContent(file_).paid, 1);
}

TEST_F(EvaluationStoreTest, GivesWayAfterAnEvaluationThatThrows) {
  EvaluationStore store(file_, kContext);
  EXPECT_THROW(store.FindOrEvaluate(At(1), []() -> Evaluation { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_FALSE(store.Find(At(1)));
  EXPECT_EQ(store.FindOrEvaluate(At(1), [] { return Residuals({3}); }).evaluation.residuals[0], 3);
}

TEST_F(EvaluationStoreTest, TakesAnEmptyFileForANewOne) {
  const std::filesystem::path file = folder_.Write("archive.sqlite", "");
  EXPECT_THAT(ChangedParts(file, kContext), IsEmpty());
  EXPECT_EQ(OutputErrorOf(file), "");
}

TEST_F(EvaluationStoreTest, SaysWhereItCannotWrite) {
  EXPECT_THAT(OutputErrorOf("/proc/fourpost/archive.sqlite"),
              testing::AllOf(HasSubstr("/proc/fourpost"), HasSubstr("[archive-folder]")));
  std::filesystem::create_directories(file_);
  EXPECT_THAT(OutputErrorOf(file_), testing::AllOf(HasSubstr("archive.sqlite: "), HasSubstr("[archive-not-written]")));
}

}  // namespace
}  // namespace fourpost::evaluation_store_test
