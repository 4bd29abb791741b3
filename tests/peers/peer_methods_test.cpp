#include "tests/peers/peer_methods.h"

#include <atomic>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "analysis/signals/mix_bits.h"
#include "identify/comparison/comparison_json.h"
#include "tests/findings.h"
#include "tests/identify/test_problems.h"
#include "tests/peers/findings.h"

namespace fourpost::peer_methods_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Pair;

const LatticePoint kCentre = {301, 501, 701};

double FromCentre(const Eigen::VectorXd& values) { return (values - Eigen::Vector3d(3, 5, 7)).norm(); }

// A sphere about a lattice point off the middle, 1000 steps on each side.
Problem Sphere() {
  const std::vector<LatticeAxis> axes = {{"x", 0, 10, 0.01}, {"y", 0, 10, 0.01}, {"z", 0, 10, 0.01}};
  return {Lattice(axes), [](const Eigen::VectorXd& values) { return OneResidual(FromCentre(values)); }};
}

bool Fails(const LatticePoint& point) {
  std::uint64_t hash = 0;
  for (const std::int64_t index : point) hash = MixBits(hash ^ static_cast<std::uint64_t>(index));
  return hash % 10 < 3;
}

// Within 0.05 on each axis, near enough for any order of costs but the right one to miss.
constexpr double kNear = 3 * 0.05 * 0.05;

struct PeerRun {
  SearchEnd end = SearchEnd::kNotRun;
  EvaluationCounts counts;
  std::vector<Improvement> improvements;
  double best() const { return improvements.empty() ? INFINITY : improvements.back().cost; }
};

PeerRun RunPeer(const std::string& name, const Problem& problem, const StopRules& rules, std::uint64_t seed = 1,
                const std::function<bool()>& stop = {}) {
  Archive archive(problem);
  PeerRun run;
  run.end = PeerMethod(name).foreign->run(archive, seed, rules, stop);
  run.counts = archive.counts();
  run.improvements = archive.improvements();
  return run;
}

class EachPeer : public testing::TestWithParam<std::string> {};

TEST_P(EachPeer, SolvesASphereInThreeDimensions) {
  const PeerRun run = RunPeer(GetParam(), Sphere(), {.target_cost = 0.0, .max_evaluations = 40000});
  // ISRES closes in slowly.
  EXPECT_LE(run.best(), GetParam() == "nlopt_isres" ? kNear : 0);
  if (run.end != SearchEnd::kTarget) return;
  // It ended with the evaluation that reached the target.
  EXPECT_EQ(run.counts.paid, run.improvements.back().paid);
}

TEST_P(EachPeer, PaysForDistinctPointsOfTheLatticeWithinItsBounds) {
  std::set<std::vector<double>> asked;
  // 8000 points, so that some are asked for again.
  Problem problem = {Lattice({{"x", -4, 5.5, 0.5}, {"y", 1, 20, 1, true}, {"z", -4, 5.5, 0.5}}), {}};
  problem.evaluate = [&](const Eigen::VectorXd& values) {
    EXPECT_TRUE((values.array() >= Eigen::Array3d(-4, 1, -4)).all());
    EXPECT_TRUE((values.array() <= Eigen::Array3d(5.5, 20, 5.5)).all());
    for (const double value : values) EXPECT_EQ(value * 2, std::round(value * 2));
    EXPECT_TRUE(asked.emplace(values.begin(), values.end()).second) << "paid for twice";
    // Falls towards a corner, so that peers press against the bounds.
    return OneResidual(values.sum());
  };
  const PeerRun run = RunPeer(GetParam(), problem, {.max_evaluations = 1500, .max_free_generations = 100});
  EXPECT_GT(asked.size(), 100u);
  EXPECT_EQ(run.counts.paid, static_cast<std::int64_t>(asked.size()));
  EXPECT_GT(run.counts.reused, 0);
}

TEST_P(EachPeer, SpendsItsEvaluationsAndNoMore) {
  const PeerRun run = RunPeer(GetParam(), Sphere(), {.max_evaluations = 137});
  EXPECT_EQ(run.end, SearchEnd::kEvaluations);
  EXPECT_EQ(run.counts.paid, 137);
}

TEST_P(EachPeer, SolvesWhereThreeEvaluationsOfTenFail) {
  Problem problem = Sphere();
  const Lattice lattice = problem.lattice;
  problem.evaluate = [lattice](const Eigen::VectorXd& values) {
    return OneResidual(Fails(lattice.Nearest(values)) ? NAN : FromCentre(values));
  };
  ASSERT_FALSE(Fails(kCentre));
  const PeerRun run = RunPeer(GetParam(), problem, {.target_cost = kNear, .max_evaluations = 20000});
  EXPECT_EQ(run.end, SearchEnd::kTarget);
  EXPECT_NEAR(static_cast<double>(run.counts.failed()), 0.3 * static_cast<double>(run.counts.paid),
              4 * std::sqrt(0.21 * static_cast<double>(run.counts.paid)));  // four deviations of the share
}

// Feasible is one thousandth of the box; without the order of violations it is found by chance alone.
TEST_P(EachPeer, IsLedByViolations) {
  Problem problem = Sphere();
  problem.evaluate = [](const Eigen::VectorXd& values) {
    const double outside = (values - Eigen::Vector3d(3, 5, 7)).cwiseAbs().maxCoeff() - 0.5;
    return outside > 0 ? Infeasible(outside, "outside") : OneResidual(1 + FromCentre(values));
  };
  std::int64_t first = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PeerRun run = RunPeer(GetParam(), problem, {.max_evaluations = 1500}, seed);
    first += run.improvements.empty() ? 1500 : run.improvements.front().paid;
  }
  // By chance it would take 1000 each.
  EXPECT_LT(first, 5 * 500);
}

TEST_P(EachPeer, IsTheSameForTheSameSeed) {
  const StopRules rules = {.max_evaluations = 600};
  const auto costs = [&](std::uint64_t seed) {
    std::vector<double> all;
    for (const Improvement& improvement : RunPeer(GetParam(), Sphere(), rules, seed).improvements)
      all.push_back(improvement.cost);
    return all;
  };
  EXPECT_EQ(costs(5), costs(5));
  EXPECT_NE(costs(5), costs(6));
}

TEST_P(EachPeer, EndsWhereNothingIsNew) {
  const Problem four = {Lattice({{"a", 0, 1, 1}, {"b", 0, 1, 1}}),
                        [](const Eigen::VectorXd& values) { return OneResidual(values.sum()); }};
  const PeerRun run = RunPeer(GetParam(), four, {.max_free_generations = 50});
  EXPECT_EQ(run.end, SearchEnd::kNothingNew);
  EXPECT_EQ(run.counts.paid, 4);
}

TEST_P(EachPeer, StopsWhenToldTo) {
  int asked = 0;
  const PeerRun run = RunPeer(GetParam(), Sphere(), {}, 1, [&] { return ++asked > 50; });
  EXPECT_EQ(run.end, SearchEnd::kStopped);
  EXPECT_LE(run.counts.paid, 50);
}

TEST_P(EachPeer, IsComparedAsOurMethodsAre) {
  const Problem problem = Sphere();
  const std::vector<ComparedMethod> methods = {{"de", MethodPreset("de", problem)}, PeerMethod(GetParam())};
  const auto json = [&](int threads) {
    const ComparisonOptions options = {
        .runs = 4, .seed = 3, .threads = threads, .rules = {.target_cost = 1.0, .max_evaluations = 3000}};
    return ComparisonJson(Compare(problem, methods, options), "sphere", 3);
  };
  EXPECT_EQ(json(1), json(4));
  EXPECT_THAT(json(1), HasSubstr("\"patience\": \"50\""));
}

std::vector<std::string> Names() {
  const std::vector<std::string_view> names = PeerNames();
  return {names.begin(), names.end()};
}

INSTANTIATE_TEST_SUITE_P(PeerMethod, EachPeer, testing::ValuesIn(Names()),
                         [](const auto& named) { return std::string(named.param); });

TEST(PeerMethod, ChangesSettings) {
  const ComparedMethod method = PeerMethod("pagmo_de:population=33:variant=7");
  EXPECT_EQ(method.name, "pagmo_de:population=33:variant=7");
  EXPECT_THAT(method.foreign->settings, Contains(Pair("population", "33")));
  EXPECT_THAT(method.foreign->settings, Contains(Pair("variant", "7")));
  EXPECT_THAT(method.foreign->settings, Contains(Pair("crossover", "0.9")));
}

Diagnostics Fault(const std::string& name) {
  std::vector<std::string> names = {name};
  Diagnostics diagnostics;
  EXPECT_TRUE(TakePeers(names, diagnostics).empty());
  return diagnostics;
}

TEST(PeerMethod, NamesFaults) {
  EXPECT_THAT(Fault("pagmo_sad"), ReportsOption(kPeerUnknown, "--methods", {"'pagmo_sad'", "'pagmo_sade'"}));
  EXPECT_THAT(Fault("nlopt_crs2:popluation=9"),
              ReportsOption(kPeerSettingUnknown, "--methods", {"'popluation'", "'population'"}));
  EXPECT_THAT(Fault("pagmo_sade:population=6"),
              ReportsOption(kPeerSettingOutOfRange, "--methods", {"population = 6", "7 to 100000"}));
  EXPECT_THAT(Fault("scipy_de:crossover"),
              ReportsOption(kPeerSettingOutOfRange, "--methods", {"crossover = nan", "0 to 1"}));
}

TEST(PeerMethod, LeavesOurNamesAlone) {
  std::vector<std::string> names = {"dvhde", "scipy_de", "de", "scipy_de"};
  Diagnostics diagnostics;
  EXPECT_EQ(TakePeers(names, diagnostics).size(), 1u);
  EXPECT_THAT(names, testing::ElementsAre("dvhde", "de"));
  EXPECT_THAT(diagnostics, ReportsOption(kPeerTwice, "--methods", {"'scipy_de'"}));
}

}  // namespace
}  // namespace fourpost::peer_methods_test
