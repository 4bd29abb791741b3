// Searches of models that fail, throw and hang.
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

#include <gmock/gmock.h>

#include "analysis/signals/mix_bits.h"
#include "identify/refine/search_method_list.h"
#include "identify/refine/several_starts.h"

namespace fourpost::unreliable_model_test {
namespace {

/// Where a sphere's centre is.
const Eigen::Vector3d kCentre(0.62, 0.37, 0.71);

enum class Cell { kGood, kFails, kThrows, kHangs };

/// The unit box in 10 x 10 x 10 cells: 30 % of them fail, 5 % throw, 2 % hang, all over the place; that of the centre
/// is good.
Cell CellOf(const Eigen::VectorXd& p) {
  std::uint64_t number = 0;
  bool holds_centre = true;
  for (Eigen::Index j = 0; j < 3; ++j) {
    const auto index = [](double x) { return static_cast<std::uint64_t>(std::min(9.0, std::floor(10 * x))); };
    number = 10 * number + index(p[j]);
    holds_centre &= index(p[j]) == index(kCentre[j]);
  }
  if (holds_centre) return Cell::kGood;
  const std::uint64_t percent = MixBits(number) % 100;
  if (percent < 30) return Cell::kFails;
  if (percent < 35) return Cell::kThrows;
  return percent < 37 ? Cell::kHangs : Cell::kGood;
}

Evaluation UnreliableSphere(const Eigen::VectorXd& p, const Deadline& deadline) {
  switch (CellOf(p)) {
    case Cell::kFails: return Failed(Failure::kNotConverged, "no periodic response");
    case Cell::kThrows: throw std::runtime_error("no vehicle");
    case Cell::kHangs:
      while (true) deadline.Check();
    case Cell::kGood: break;
  }
  Evaluation evaluation;
  evaluation.residuals = 100 * (p - kCentre);
  return evaluation;
}

Problem Sphere() {
  return {.lattice = Lattice({{"x", 0, 1, 1e-3}, {"y", 0, 1, 1e-3}, {"z", 0, 1, 1e-3}}),
          .evaluate = UnreliableSphere,
          .residual_count = 3,
          .deadline_s = 2e-3};
}

TEST(UnreliableModel, HasTheSharesOfTheRequirement) {
  std::array<int, 4> cells = {};
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      for (int z = 0; z < 10; ++z)
        ++cells[static_cast<std::size_t>(CellOf(0.05 * Eigen::Vector3d(2 * x + 1, 2 * y + 1, 2 * z + 1)))];
  // Two standard deviations of a binomial number of 1000.
  EXPECT_NEAR(cells[1], 300, 29);
  EXPECT_NEAR(cells[2], 50, 14);
  EXPECT_NEAR(cells[3], 20, 9);
}

class UnreliableModelMethods : public testing::TestWithParam<const char*> {};

TEST_P(UnreliableModelMethods, AreSolvedByEverySeed) {
  const Problem problem = Sphere();
  // Within half a step of the lattice in each direction.
  const double target = 3 * std::pow(100 * 0.5e-3, 2);
  const StopRules rules = {.target_cost = target, .max_evaluations = 3000};
  std::map<Failure, std::int64_t> failures;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Archive archive(problem, 2);
    const SearchResult result = RunMethod(MethodPreset(GetParam(), problem), archive, seed, rules, {}, {});
    EXPECT_EQ(result.end, SearchEnd::kTarget) << "seed " << seed << ": " << result.reason;
    for (const auto& [failure, tally] : archive.counts().failures) failures[failure] += tally.count;
  }
  // Nothing else than what the model does, and all of that.
  ASSERT_EQ(failures.size(), 3u);
  EXPECT_GT(failures[Failure::kNotConverged], 50);
  EXPECT_GT(failures[Failure::kException], 5);
  EXPECT_GT(failures[Failure::kTimedOut], 2);
}

INSTANTIATE_TEST_SUITE_P(Presets, UnreliableModelMethods, testing::Values("dvhde", "direct"),
                         [](const auto& parameter) { return std::string(parameter.param); });

// As a fit of a vehicle goes about it.
TEST(UnreliableModel, IsSolvedByDvhdeAndRefinementsFromEverySeed) {
  const Problem problem = Sphere();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Archive archive(problem, 2);
    Dvhde dvhde(archive.lattice(), ThesisDvhde(), seed);
    const SearchResult search = RunSearch(archive, dvhde, {.max_evaluations = 300}, {.count = 4});
    std::vector<Eigen::VectorXd> starts;
    for (const Candidate& candidate : search.candidates) starts.push_back(candidate.values);
    const MultiStartResult refined = RefineFrom(archive, starts);
    ASSERT_GE(refined.best, 0) << seed;
    const RefineResult& best = refined.runs[static_cast<std::size_t>(refined.best)];
    EXPECT_EQ(best.end, RefineEnd::kConverged) << seed << ": " << best.message;
    // The refinement ends with steps below 1e-8 of the variables.
    EXPECT_LT(best.cost, 3 * std::pow(100 * 1e-8, 2)) << seed;
  }
}

TEST(UnreliableModel, NamesTheCauseWhereAllFails) {
  Problem problem = Sphere();
  problem.evaluate = [](const Eigen::VectorXd&, const Deadline& deadline) -> Evaluation {
    while (true) deadline.Check();
  };
  Archive archive(problem, 2);
  const SearchResult result = RunMethod(MethodPreset("thesis", problem), archive, 1, {.max_evaluations = 40}, {}, {});
  EXPECT_TRUE(result.candidates.empty());
  ASSERT_EQ(archive.counts().failures.size(), 1u);
  EXPECT_EQ(archive.counts().failures.at(Failure::kTimedOut).count, 40);
  EXPECT_EQ(archive.counts().failures.at(Failure::kTimedOut).example, "took longer than 0.002 s");
}

}  // namespace
}  // namespace fourpost::unreliable_model_test
