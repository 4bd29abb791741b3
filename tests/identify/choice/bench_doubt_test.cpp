// A bench fit with a stated covariance, written by hand, and what choices draw of it.
#include "identify/choice/bench_doubt.h"

#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include "identify/choice/choice.h"
#include "identify/choice/findings.h"
#include "identify/run/run_draws.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::bench_doubt_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr const char* kDamper = R"(<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1"><link name="tube"/>
<link name="rod"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
<limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
<fp:parameter name="c" value="500 N*s/m" lower="0.1 kN*s/m" upper="9 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:parameter name="c_at_1" value="900 N*s/m" lower="0.1 kN*s/m" upper="9 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:parameter name="c_at_2" value="1500 N*s/m" lower="0.1 kN*s/m" upper="9 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:damper name="mr" parent="tube" child="rod"><linear rate="$c"/></fp:damper>
</robot>)";

std::string ParameterJson(const std::string& name, double value) {
  return R"({"name":")" + name + R"(","value":)" + std::to_string(value) +
         R"(,"unit":"N*s/m","lower":100,"upper":9000})";
}

/// Each rate has the relative standard deviation `sd`, independent of the others, of which noise is a tenth.
void WriteBench(const TemporaryFolder& folder, const std::string& name, double sd) {
  std::filesystem::create_directory(folder.path() / name);
  folder.Write(name + "/vehicle.urdf", kDamper);
  folder.Write(name + "/study.yaml",
               "vehicle: vehicle.urdf\ncontrol: {c: per setting}\nbench:\n  recordings:\n"
               "    - {file: 0.csv, control: 0}\n    - {file: 1.csv, control: 1}\n    - {file: 2.csv, control: 2}\n");
  const auto triangle = [](double deviation) {
    const std::string v = std::to_string(deviation * deviation);
    return "[[" + v + "],[0," + v + "],[0,0," + v + "]]";
  };
  folder.Write(name + "/result.json",
               R"({"parameters":[)" + ParameterJson("c", 500) + "," + ParameterJson("c_at_1", 900) + "," +
                   ParameterJson("c_at_2", 1500) +
                   R"(],"cost":1,"identifiability":{"sd_inflation":1},"starts":{"runs":[]},)"
                   R"("intervals":{"confidence":"80 to 90 %","moved_by_post_noise":[],"covariance":)"
                   R"({"parameters":["c","c_at_1","c_at_2"],"noise":)" +
                   triangle(0.1 * sd) + R"(,"total":)" + triangle(sd) + "}}}");
}

/// Positions 0, 0.5, 1, 1.5 and 2 of the bench's rate set parameter `of`, doubled.
Knob KnobOf(const std::string& name, std::size_t of, const std::filesystem::path& run) {
  Knob knob{.name = name, .line = 2, .parameters = {of}};
  knob.bench = Knob::Bench{.run = run, .columns = {0}, .factors = {2}, .rows = {0, 0.5, 1, 1.5, 2}};
  const std::vector<double> rates = {500, 700, 900, 1200, 1500};
  for (std::size_t i = 0; i < rates.size(); ++i) knob.positions.push_back({std::to_string(i), {2 * rates[i]}});
  return knob;
}

struct Moments {
  double mean;
  double sd;
};

Moments LogMoments(const MatrixXd& drawn) {
  const Eigen::ArrayXd logs = drawn.col(0).array().log();
  return {logs.mean(), std::sqrt((logs - logs.mean()).square().sum() / static_cast<double>(logs.size() - 1))};
}

double Correlation(const MatrixXd& a, const MatrixXd& b) {
  const Eigen::ArrayXd x = a.col(0).array() - a.col(0).mean();
  const Eigen::ArrayXd y = b.col(0).array() - b.col(0).mean();
  return (x * y).sum() / std::sqrt(x.square().sum() * y.square().sum());
}

TEST(BenchDoubt, IsThatOfTheWideIntervals) {
  const TemporaryFolder folder;
  WriteBench(folder, "bench", 0.08);
  std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "bench")};
  const BenchDraws drawn = DrawBenches(knobs, "settings.yaml", {.count = 2000}, {});
  ASSERT_EQ(drawn.benches.size(), 1U);
  EXPECT_EQ(drawn.benches[0].confidence, "80 to 90 %");
  EXPECT_THAT(drawn.benches[0].parameters, testing::ElementsAre("c", "c_at_1", "c_at_2"));
  // Standard errors of a mean and a standard deviation of 2000 normal draws, four times.
  const Moments at_1 = LogMoments(knobs[0].positions[2].drawn);
  EXPECT_NEAR(at_1.mean, std::log(1800), 4 * 0.08 / std::sqrt(2000));
  EXPECT_NEAR(at_1.sd, 0.08, 4 * 0.08 / std::sqrt(4000));
  // Between two rows a car takes the straight line between its own two laws.
  constexpr double kRounding = 1e-9;
  for (Index d = 0; d < 2000; ++d)
    EXPECT_NEAR(knobs[0].positions[3].drawn(d, 0),
                0.5 * (knobs[0].positions[2].drawn(d, 0) + knobs[0].positions[4].drawn(d, 0)), kRounding);
}

TEST(BenchDoubt, IsSharedWithinAFitAndNotBetweenFits) {
  const TemporaryFolder folder;
  WriteBench(folder, "bench", 0.08);
  WriteBench(folder, "other", 0.08);
  std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "bench"),
                             KnobOf("rear", 1, folder.path() / "other/../bench"),
                             KnobOf("third", 2, folder.path() / "other")};
  const BenchDraws drawn = DrawBenches(knobs, "settings.yaml", {.count = 1000}, {});
  ASSERT_EQ(drawn.benches.size(), 2U);
  EXPECT_THAT(drawn.benches[0].knobs, testing::ElementsAre("front", "rear"));
  EXPECT_EQ(knobs[0].positions[4].drawn, knobs[1].positions[4].drawn);
  // Four standard errors of a correlation of none.
  const double none = 4 / std::sqrt(1000);
  EXPECT_LT(std::abs(Correlation(knobs[0].positions[4].drawn, knobs[2].positions[4].drawn)), none);
  EXPECT_LT(std::abs(Correlation(knobs[0].positions[0].drawn, knobs[0].positions[4].drawn)), none);
}

// The car's own fit is drawn once: where it sets the knob, the knob follows.
TEST(BenchDoubt, OfTheCarItselfIsThatOfItsDraws) {
  const TemporaryFolder folder;
  WriteBench(folder, "run", 0.08);
  std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "run/")};
  const BenchDraws drawn =
      DrawBenches(knobs, "settings.yaml", {.car = folder.path() / "run", .count = 50, .seed = 3, .threads = 1}, {});
  EXPECT_TRUE(drawn.benches.empty());
  const std::optional<RunDraws> car =
      DrawFromRun({.run = folder.path() / "run", .count = 50, .seed = 3, .threads = 1}, {});
  ASSERT_TRUE(car);
  ASSERT_EQ(car->names[0], "c");
  EXPECT_EQ(knobs[0].positions[0].drawn.col(0), 2 * car->values.col(0));
}

TEST(BenchDoubt, NamesItsBenchAndWhatKnobsFollowOfIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "rear");
  WriteBench(folder, "bench", 0.08);
  std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "bench/")};
  knobs[0].positions.resize(2);
  knobs[0].bench->rows = {0, 1};
  const BenchDraws one = DrawBenches(knobs, "settings.yaml", {.count = 5}, {});
  EXPECT_EQ(one.benches.at(0).name, "bench");
  EXPECT_THAT(one.benches[0].parameters, testing::ElementsAre("c", "c_at_1"));
  WriteBench(folder, "rear/bench", 0.08);
  knobs.push_back(KnobOf("rear", 1, folder.path() / "rear/bench"));
  const BenchDraws two = DrawBenches(knobs, "settings.yaml", {.count = 5}, {});
  EXPECT_EQ(two.benches.at(1).name, (folder.path() / "rear/bench").string());
}

// Repeats of a choice are independent.
TEST(BenchDoubt, OfOneBenchIsNotThatOfAnotherWithAnotherSeed) {
  const TemporaryFolder folder;
  WriteBench(folder, "bench", 0.08);
  WriteBench(folder, "other", 0.08);
  const auto knobs_at = [&](std::uint64_t seed) {
    std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "bench"), KnobOf("rear", 1, folder.path() / "other")};
    DrawBenches(knobs, "settings.yaml", {.count = 20, .seed = seed}, {});
    return knobs;
  };
  EXPECT_NE(knobs_at(1)[1].positions[0].drawn, knobs_at(2)[0].positions[0].drawn);
}

TEST(BenchDoubt, OfAFitWithoutCovarianceIsAFinding) {
  const TemporaryFolder folder;
  WriteBench(folder, "bench", 0.08);
  folder.Write("bench/result.json", "{}");
  std::vector<Knob> knobs = {KnobOf("front", 0, folder.path() / "bench")};
  const BenchDraws drawn = DrawBenches(knobs, "settings.yaml", {}, {});
  EXPECT_TRUE(drawn.benches.empty());
  EXPECT_EQ(knobs[0].positions[0].drawn.size(), 0);
  EXPECT_THAT(drawn.findings, Reports(kBenchWithoutDoubt, 2, {"bench"}));
}

/// A car that is certain and best at 1850, near position 2: only the laws of the positions are in doubt.
Choice ChoiceOf(double sd, int threads) {
  const TemporaryFolder folder;
  WriteBench(folder, "bench", sd);
  ChoiceRequest request;
  request.settings.file = "settings.yaml";
  request.settings.knobs = {KnobOf("front", 0, folder.path() / "bench")};
  request.settings.roads = {{.name = "B", .road_class = "B", .speed = 20}};
  request.settings.objectives = {{.metric = 0, .weight = 1}};
  request.metrics = {{.name = "discomfort"}};
  request.spectra = [](std::span<const double> p) {
    return MatrixXd::Constant(1, 1, 1 + std::pow((p[0] - 1850) / 1000, 2));
  };
  request.fitted = {1000};
  request.parameters = {"c"};
  request.threads = threads;
  constexpr std::size_t kDraws = 400;
  const BenchDraws drawn =
      DrawBenches(request.settings.knobs, request.settings.file, {.count = kDraws, .threads = threads}, {});
  request.draws = MatrixXd::Constant(kDraws, 1, 1000);
  request.bench_draws = drawn.benches[0].draws;
  for (const std::string& name : drawn.benches[0].parameters) request.parameters.push_back(name + " of bench");
  return Choose(request, {});
}

TEST(BenchDoubt, LowersTheProbabilityOfTheBestAndRaisesItsRegret) {
  double probability = 1;
  double regret = 0;
  for (const double sd : {0.02, 0.15, 0.3}) {
    const Choice choice = ChoiceOf(sd, 1);
    const RatedSetting& at_2 = choice.rows[2];
    if (sd > 0.02) {
      EXPECT_LT(at_2.best_probability, probability - 0.1) << sd;
      EXPECT_GT(at_2.regret, regret) << sd;
    }
    probability = at_2.best_probability;
    regret = at_2.regret;
    // The only doubt is the bench's.
    for (const DecidingParameter& one : choice.deciding) EXPECT_GT(one.parameter, 0U);
  }
  EXPECT_GT(ChoiceOf(0.02, 1).rows[2].best_probability, 0.99);
}

TEST(BenchDoubt, IsTheSameForAnyNumberOfThreads) {
  const Choice one = ChoiceOf(0.1, 1);
  const Choice three = ChoiceOf(0.1, 3);
  for (std::size_t s = 0; s < one.rows.size(); ++s) {
    EXPECT_EQ(one.rows[s].best_probability, three.rows[s].best_probability);
    EXPECT_EQ(one.rows[s].regret, three.rows[s].regret);
  }
}

}  // namespace
}  // namespace fourpost::bench_doubt_test
