#include "identify/search/archive.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/refine/search_method_list.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde_operators.h"
#include "tests/identify/test_problems.h"
#include "tests/temporary_folder.h"

namespace fourpost::archive_test {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

// Values 0..10 on both axes.
Lattice Square() { return Lattice({{"a", 0, 10, 1}, {"b", 0, 10, 1}}); }

// Cost (a - 3)^2, whatever b.
Problem Valley() {
  return {Square(), [](const Eigen::VectorXd& p) { return OneResidual(p[0] - 3); }};
}

// Fails in five ways for a = 0..5, else costs a^2.
Evaluation Unreliable(const Eigen::VectorXd& p) {
  switch (static_cast<int>(p[0])) {
    case 0: return OneResidual(std::nan(""));
    case 1: return OneResidual(HUGE_VAL);
    case 2: throw std::runtime_error("at b = " + std::to_string(static_cast<int>(p[1])));
    case 3: return Failed(Failure::kNotConverged, "no limit cycle");
    case 4: return Failed(Failure::kInfeasible, "no vehicle");
    case 5: return Evaluation();
    default: return OneResidual(p[0]);
  }
}

std::vector<LatticePoint> AllPoints() {
  std::vector<LatticePoint> points;
  for (std::int64_t a = 1; a <= 11; ++a) {
    for (std::int64_t b = 1; b <= 11; ++b) points.push_back({a, b});
  }
  return points;
}

TEST(IsBetter, IsStrictAndAFailureIsWorstOfAll) {
  const Score failure = {0, Failure::kNotFinite};
  EXPECT_TRUE(IsBetter({1}, {2}));
  EXPECT_FALSE(IsBetter({2}, {1}));
  EXPECT_FALSE(IsBetter({1}, {1}));
  EXPECT_TRUE(IsBetter({1e300}, failure));
  EXPECT_FALSE(IsBetter(failure, {1e300}));
  EXPECT_FALSE(IsBetter(failure, failure));
}

TEST(Archive, PaysForNoPointTwice) {
  std::mutex mutex;
  std::map<std::pair<double, double>, int> calls;
  Archive archive({Square(),
                   [&](const Eigen::VectorXd& p) {
                     const std::lock_guard lock(mutex);
                     ++calls[{p[0], p[1]}];
                     return Unreliable(p);
                   }},
                  4);
  Draws draws(1, DrawPurpose::kTrial, 0, 0);
  const int batches = 50;
  const int batch_size = 20;
  for (int batch = 0; batch < batches; ++batch) {
    std::vector<LatticePoint> points;
    for (int i = 0; i < batch_size; ++i) points.push_back(RandomPoint(archive.lattice(), draws));
    archive.Evaluate(points);
  }
  for (const auto& [point, count] : calls) EXPECT_EQ(count, 1);
  EXPECT_EQ(archive.counts().paid, static_cast<std::int64_t>(calls.size()));
  EXPECT_EQ(archive.counts().paid + archive.counts().reused, batches * batch_size);
  EXPECT_EQ(archive.size(), calls.size());
}

TEST(Archive, ScoresABatchInItsOrder) {
  Archive archive(Valley());
  const std::vector<Score> scores = archive.Evaluate({{6, 1}, {4, 1}, {6, 1}, {1, 1}});
  EXPECT_THAT(scores, ElementsAre(Score{4}, Score{0}, Score{4}, Score{9}));
  EXPECT_EQ(archive.counts().paid, 3);
  EXPECT_EQ(archive.counts().reused, 1);
  EXPECT_THAT(archive.Evaluate({{1, 1}, {5, 1}}), ElementsAre(Score{9}, Score{1}));
  EXPECT_EQ(archive.counts().paid, 4);
  EXPECT_EQ(archive.counts().reused, 2);
}

TEST(Archive, FindsWhatItKnowsAndPaysNothing) {
  Archive archive(Valley());
  archive.Evaluate({{6, 1}});
  EXPECT_EQ(archive.Find({6, 1}), Score{4});
  EXPECT_FALSE(archive.Find({6, 2}));
  EXPECT_EQ(archive.counts().paid, 1);
  EXPECT_EQ(archive.counts().reused, 0);
}

TEST(Archive, TalliesFailuresByCauseWithTheFirstInTheBatchAsExample) {
  Archive archive({Square(), Unreliable}, 4);
  archive.Evaluate(AllPoints());
  const EvaluationCounts& counts = archive.counts();
  ASSERT_EQ(counts.failures.size(), 5u);
  EXPECT_EQ(counts.failures.at(Failure::kNotFinite).count, 22);
  EXPECT_EQ(counts.failures.at(Failure::kException).count, 11);
  EXPECT_EQ(counts.failures.at(Failure::kException).example, "at b = 0");
  EXPECT_EQ(counts.failures.at(Failure::kNotConverged).count, 11);
  EXPECT_EQ(counts.failures.at(Failure::kNotConverged).example, "no limit cycle");
  EXPECT_EQ(counts.failures.at(Failure::kInfeasible).count, 11);
  EXPECT_EQ(counts.failures.at(Failure::kWrongSize).count, 11);
  EXPECT_EQ(counts.failed(), 66);
  EXPECT_EQ(counts.paid, 121);
}

TEST(Archive, GivesAFailureForAFailureAndNeverAnInfiniteOrNanCost) {
  Archive archive({Square(), Unreliable});
  const std::vector<LatticePoint> points = AllPoints();
  const std::vector<Score> scores = archive.Evaluate(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(scores[i].ok(), points[i][0] > 6);
    EXPECT_TRUE(std::isfinite(scores[i].cost));
  }
  for (const Candidate& candidate : archive.Best(121, 0)) EXPECT_GE(candidate.cost, 36);
}

TEST(Archive, FailsAnEvaluationWithAnotherNumberOfResiduals) {
  Archive archive({Square(), [](const Eigen::VectorXd& p) {
                     Evaluation evaluation;
                     evaluation.residuals = Eigen::VectorXd::Ones(p[0] > 5 ? 1 : 3);
                     return evaluation;
                   }});
  const std::vector<Score> scores = archive.Evaluate({{1, 1}, {11, 1}, {2, 1}});
  EXPECT_EQ(scores[0], Score{3});
  EXPECT_EQ(scores[1].failure, Failure::kWrongSize);
  EXPECT_EQ(scores[2], Score{3});
  EXPECT_EQ(archive.counts().failures.at(Failure::kWrongSize).example, "1 residuals, elsewhere 3");
  EXPECT_FALSE(archive.EvaluateValues({Eigen::Vector2d(7.5, 0)}).front().ok());
}

TEST(Archive, GivesTheSameForAnyNumberOfThreads) {
  const std::vector<LatticePoint> points = AllPoints();
  Archive alone({Square(), Unreliable}, 1);
  const std::vector<Score> scores = alone.Evaluate(points);
  for (const int threads : {2, 4, 0}) {
    Archive archive({Square(), Unreliable}, threads);
    EXPECT_EQ(archive.Evaluate(points), scores);
    EXPECT_EQ(archive.counts().paid, alone.counts().paid);
    for (const auto& [failure, tally] : alone.counts().failures) {
      EXPECT_EQ(archive.counts().failures.at(failure).count, tally.count);
      EXPECT_EQ(archive.counts().failures.at(failure).example, tally.example);
    }
  }
}

// Each of two evaluations waits until the other has begun; the wait ends only where they run one after the other.
TEST(Archive, EvaluatesSeveralPointsAtOnce) {
  std::mutex mutex;
  std::condition_variable begun;
  int running = 0;
  std::atomic<int> met = 0;
  Archive archive({Square(),
                   [&](const Eigen::VectorXd&) {
                     std::unique_lock lock(mutex);
                     ++running;
                     begun.notify_all();
                     met += begun.wait_for(lock, std::chrono::seconds(30), [&] { return running == 2; });
                     return OneResidual(0);
                   }},
                  2);
  archive.Evaluate({{1, 1}, {2, 2}});
  EXPECT_EQ(met, 2);
}

TEST(Archive, ForgetsValuesOffTheLatticeButCountsThem) {
  Archive archive(Valley());
  const Eigen::VectorXd values = Eigen::Vector2d(3.5, 1);
  EXPECT_EQ(archive.EvaluateValues({values, values}).back().cost(), 0.25);
  archive.EvaluateValues({values});
  EXPECT_EQ(archive.counts().paid, 3);
  EXPECT_EQ(archive.counts().reused, 0);
  EXPECT_EQ(archive.size(), 0u);
}

TEST(Archive, AnswersAnEmptyBatchWithNothing) {
  Archive archive(Valley(), 2);
  EXPECT_TRUE(archive.Evaluate({}).empty());
  EXPECT_TRUE(archive.EvaluateValues({}).empty());
  EXPECT_TRUE(archive.Best(3, 0).empty());
}

TEST(Archive, RanksByCostThenByIndex) {
  Archive archive(Valley());
  archive.Evaluate({{5, 2}, {4, 9}, {3, 7}, {4, 1}});
  std::vector<LatticePoint> points;
  for (const Candidate& candidate : archive.Best(10, 0)) points.push_back(candidate.point);
  EXPECT_THAT(points, ElementsAre(LatticePoint{4, 1}, LatticePoint{4, 9}, LatticePoint{3, 7}, LatticePoint{5, 2}));
  EXPECT_EQ(archive.Best(2, 0).size(), 2u);
  EXPECT_EQ(archive.Best(10, 0).front().values, Eigen::Vector2d(3, 0));
}

TEST(Archive, ReportsGoodPointsFurtherApartThanAsked) {
  Archive archive(Valley());
  archive.Evaluate(AllPoints());
  const std::vector<Candidate> best = archive.Best(4, 0.3);
  // Of b = 0..10, each more than 3 steps from the one before.
  ASSERT_EQ(best.size(), 4u);
  EXPECT_EQ(best[0].point, (LatticePoint{4, 1}));
  EXPECT_EQ(best[1].point, (LatticePoint{4, 5}));
  EXPECT_EQ(best[2].point, (LatticePoint{4, 9}));
  EXPECT_EQ(best[3].point, (LatticePoint{8, 1}));
}

TEST(Archive, RefusesAPointOffTheLatticeBeforePayingForAny) {
  Archive archive(Valley());
  EXPECT_THROW(archive.Evaluate({{1, 1}, {12, 1}}), std::invalid_argument);
  EXPECT_EQ(archive.counts().paid, 0);
}

TEST(Archive, RefusesLessThanNoThreads) {
  EXPECT_THAT([] { Archive archive(Valley(), -1); },
              ThrowsMessage<std::invalid_argument>(StrEq("threads = -1, must be 0 or more")));
}

TEST(Archive, RemembersEachImprovementAndWhatWasPaidForIt) {
  std::vector<double> costs = {4, 9, std::nan(""), 1, 1, 0.25};
  std::size_t next = 0;
  Archive archive(
      {Lattice({{"a", 0, 100, 1}}), [&](const Eigen::VectorXd&) { return OneResidual(std::sqrt(costs[next++])); }});
  archive.Evaluate({{1}, {2}, {3}, {1}});
  archive.EvaluateValues(
      {Eigen::VectorXd::Constant(1, 0.5), Eigen::VectorXd::Constant(1, 1.5), Eigen::VectorXd::Constant(1, 2.5)});
  std::vector<std::pair<std::int64_t, double>> improvements;
  for (const Improvement& improvement : archive.improvements())
    improvements.emplace_back(improvement.paid, improvement.cost);
  EXPECT_THAT(improvements, testing::ElementsAre(testing::Pair(1, 4), testing::Pair(4, 1), testing::Pair(6, 0.25)));
}

TEST(Archive, RanksInfeasiblePointsByTheirViolation) {
  const Score good = {.cost = 1e9};
  const Score near = {.failure = Failure::kInfeasible, .violation = 0.1};
  const Score far = {.failure = Failure::kInfeasible, .violation = 2};
  const Score unknown = {.failure = Failure::kInfeasible};
  const Score failed = {.failure = Failure::kNotConverged};
  EXPECT_TRUE(IsBetter(good, near));
  EXPECT_TRUE(IsBetter(near, far));
  EXPECT_FALSE(IsBetter(far, near));
  EXPECT_TRUE(IsBetter(far, failed));
  EXPECT_FALSE(IsBetter(failed, far));
  EXPECT_FALSE(IsBetter(unknown, failed));
  EXPECT_FALSE(IsBetter(failed, unknown));
}

class StoredArchive : public testing::Test {
 protected:
  std::filesystem::path FileOf(const std::string& name) const { return folder_.path() / (name + ".sqlite"); }

  TemporaryFolder folder_;
  EvaluationStore store_ = {FileOf("archive"), {}};
  std::atomic<int> calls_ = 0;
  Problem unreliable_ = {Square(), [this](const Eigen::VectorXd& p) {
                           ++calls_;
                           return Unreliable(p);
                         }};
};

TEST_F(StoredArchive, PaysForNoPointThatAnEarlierOnePaidFor) {
  const std::vector<Eigen::VectorXd> between = {Eigen::Vector2d(7.5, 1), Eigen::Vector2d(2.5, 1)};
  Archive first(unreliable_, 2, &store_);
  const std::vector<Score> scores = first.Evaluate(AllPoints());
  first.EvaluateValues(between);
  EXPECT_EQ(calls_, 123);
  EXPECT_EQ(first.counts().restored, 0);

  Archive second(unreliable_, 2, &store_);
  EXPECT_EQ(second.Evaluate(AllPoints()), scores);
  EXPECT_EQ(second.EvaluateValues(between).front().cost(), 7.5 * 7.5);
  EXPECT_EQ(calls_, 123);
  // Counted as if nothing had been there.
  EXPECT_EQ(second.counts().restored, 123);
  EXPECT_EQ(second.counts().paid, first.counts().paid);
  EXPECT_EQ(second.counts().reused, first.counts().reused);
  EXPECT_EQ(second.improvements().size(), first.improvements().size());
  for (const auto& [failure, tally] : first.counts().failures) {
    EXPECT_EQ(second.counts().failures.at(failure).count, tally.count);
    EXPECT_EQ(second.counts().failures.at(failure).example, tally.example);
  }
}

TEST_F(StoredArchive, RemembersValuesOffTheLattice) {
  Archive archive(unreliable_, 1, &store_);
  const Eigen::VectorXd values = Eigen::Vector2d(7.5, 1);
  archive.EvaluateValues({values, values});
  EXPECT_EQ(archive.EvaluateValues({values}).front().cost(), 7.5 * 7.5);
  EXPECT_EQ(calls_, 1);
  EXPECT_EQ(archive.counts().paid, 1);
  EXPECT_EQ(archive.counts().reused, 2);
  // A lattice point is the same wherever it is asked for.
  archive.Evaluate({{8, 1}});
  archive.EvaluateValues({Eigen::Vector2d(7, 0)});
  EXPECT_EQ(calls_, 2);
  EXPECT_EQ(archive.counts().reused, 3);
}

TEST_F(StoredArchive, CountsAsWithoutAStoreWhereThatIsAskedFor) {
  const auto counts = [&](EvaluationStore* store) {
    Archive archive(unreliable_, 1, store, Repeats::kPaid);
    const Eigen::VectorXd values = Eigen::Vector2d(7.5, 1);
    archive.EvaluateValues({values, values});
    archive.Evaluate({{8, 1}, {8, 1}, {1, 1}});
    archive.EvaluateValues({values, Eigen::Vector2d(7, 0), Eigen::Vector2d(2.5, 0)});
    return archive.counts();
  };
  const EvaluationCounts without = counts(nullptr);
  EXPECT_EQ(without.paid, 7);
  EXPECT_EQ(without.reused, 1);
  for (int round = 0; round < 2; ++round) {
    const EvaluationCounts with = counts(&store_);
    EXPECT_EQ(with.paid, without.paid);
    EXPECT_EQ(with.reused, without.reused);
    EXPECT_EQ(with.failed(), without.failed());
  }
}

TEST_F(StoredArchive, FailsAnEvaluationWithAnotherNumberOfResidualsAlsoWhenItWasStored) {
  const Problem problem = {Square(), [](const Eigen::VectorXd& p) {
                             Evaluation evaluation;
                             evaluation.residuals = Eigen::VectorXd::Ones(p[0] > 5 ? 1 : 3);
                             return evaluation;
                           }};
  for (int run = 0; run < 2; ++run) {
    Archive archive(problem, 1, &store_);
    EXPECT_EQ(archive.Evaluate({{1, 1}, {11, 1}}).back().failure, Failure::kWrongSize);
  }
}

TEST_F(StoredArchive, HoldsTheSameForAnyNumberOfThreads) {
  const Problem problem = MassSpringDamper();
  std::vector<std::string> digests;
  for (const int threads : {1, 2, 4}) {
    const std::filesystem::path file = FileOf(std::to_string(threads));
    EvaluationStore store(file, {});
    Archive archive(problem, threads, &store);
    RunMethod(MethodPreset("dvhde", problem), archive, 3, {.max_evaluations = 300}, {});
    const StoredContent content = ReadStoredContent(file);
    EXPECT_EQ(content.evaluations, archive.counts().paid);
    EXPECT_EQ(content.paid, content.evaluations);
    digests.push_back(content.digest);
  }
  EXPECT_GE(ReadStoredContent(FileOf("1")).evaluations, 300);
  EXPECT_EQ(digests[1], digests[0]);
  EXPECT_EQ(digests[2], digests[0]);
}

TEST_F(StoredArchive, ServesOneMethodWithWhatAnotherPaidFor) {
  const Problem problem = MassSpringDamper();
  const auto run = [&](const char* method) {
    Archive archive(problem, 1, &store_);
    RunMethod(MethodPreset(method, problem), archive, 3, {.max_evaluations = 100}, {});
    return archive.counts();
  };
  EXPECT_EQ(run("thesis").restored, 0);
  // Both begin with the same population.
  EXPECT_GE(run("de").restored, 20);
  EXPECT_EQ(run("de").restored, run("de").paid);
}

}  // namespace
}  // namespace fourpost::archive_test
