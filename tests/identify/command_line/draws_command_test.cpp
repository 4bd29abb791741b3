// `fourpost draws` as a user meets it.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"

namespace fourpost {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

class DrawsCommandLine : public ProgramTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(Run("init car").code, 0);
    ASSERT_EQ(Run("fit car/study.yaml -o run").code, 0);
  }

  Json Draw(const std::string& options) const {
    const Outcome outcome = Run("draws run --json " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }

  Json Result() const { return Json::parse(ReadText(folder_ / "run/result.json")); }
};

/// Of draws about their mean, in logarithms.
double LogDeviation(const Json& draws, std::size_t parameter) {
  double sum = 0;
  double squares = 0;
  const auto count = static_cast<double>(draws.size());
  for (const Json& row : draws) sum += std::log(row[parameter].get<double>()) / count;
  for (const Json& row : draws) squares += std::pow(std::log(row[parameter].get<double>()) - sum, 2) / count;
  return std::sqrt(squares);
}

// Which wrote `sd` and the covariance of what is drawn.
TEST_F(DrawsCommandLine, SpreadAsTheRunSays) {
  const Json result = Result();
  const Json wide = Draw("-n 2000");
  EXPECT_EQ(wide["method"], "normal");
  EXPECT_EQ(wide["evaluations"], 0);
  const Json noise = Draw("-n 500 --noise-only --study car/study.yaml");
  EXPECT_EQ(noise["method"], "weighted");
  EXPECT_GT(noise["effective"], 300);
  EXPECT_GE(noise["evaluations"], 500);
  const Json& parameters = result["parameters"];
  ASSERT_EQ(wide["draws"][0].size(), parameters.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const Json& parameter = parameters[j];
    if (parameter["state"] != "determined" || !(parameter["lower"] > 0)) continue;
    const double sd = parameter["sd"].get<double>() / parameter["value"].get<double>();
    EXPECT_NEAR(LogDeviation(wide["draws"], j), sd, 0.1 * sd) << parameter["name"];
    const double of_noise = parameter["sd_parts"]["noise"].get<double>() / parameter["value"].get<double>();
    EXPECT_NEAR(LogDeviation(noise["draws"], j), of_noise, 0.2 * of_noise) << parameter["name"];
  }
}

TEST_F(DrawsCommandLine, AreTheSameForAnyNumberOfThreads) {
  const std::string options = "draws run --noise-only --study car/study.yaml -n 40 --seed 7 ";
  const Outcome one = Run(options + "--threads 1");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(Run(options + "--threads 2").out, one.out);
  EXPECT_NE(Run("draws run --noise-only --study car/study.yaml -n 40 --seed 8").out, one.out);
}

TEST_F(DrawsCommandLine, AreATableWithNamesAndUnits) {
  const Outcome outcome = Run("draws run -n 3 -o draws.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("parameter"));
  std::istringstream csv(ReadText(folder_ / "draws.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  const Json result = Result();
  EXPECT_THAT(lines[0], StartsWith(result["parameters"][0]["name"].get<std::string>() + ","));
  EXPECT_THAT(lines[1], StartsWith(result["parameters"][0]["unit"].get<std::string>() + ","));
}

/// Ids of the warnings of a prediction.
std::string Warnings(const Json& prediction) {
  std::string ids;
  for (const Json& warning : prediction["warnings"]) ids += warning["id"].get<std::string>() + " ";
  return ids;
}

// 12 mm were fitted: a prediction of the same motion leaves nothing, one of 20 mm all but the frequencies.
TEST_F(DrawsCommandLine, APredictionWarnsWhereItLeavesTheFit) {
  const std::string recording = ReadText(folder_ / "car/stepped_sine.csv");
  std::string larger = recording;
  for (std::size_t at = 0; (at = larger.find(",0.012,", at)) != std::string::npos;) larger.replace(at, 7, ",0.020,");
  temporary_.Write("larger.csv", larger);
  const Outcome inside = Run("predict run --recording car/stepped_sine.csv --json");
  ASSERT_EQ(inside.code, 0) << inside.err;
  const Json same = Json::parse(inside.out);
  EXPECT_THAT(Warnings(same), testing::Not(HasSubstr("-not-covered")));
  const Json& band = same["band_95"];
  EXPECT_GT(band["points"], 200);
  EXPECT_LT(band["outside"].get<double>(), 0.1 * band["points"].get<double>());
  const Outcome beyond = Run("predict run --recording larger.csv --json");
  const std::string warnings = Warnings(Json::parse(beyond.out));
  for (const char* id : {"amplitudes", "speeds", "travels", "loads"})
    EXPECT_THAT(warnings, HasSubstr(std::string(id) + "-not-covered"));
  EXPECT_THAT(warnings, testing::Not(HasSubstr("frequencies-not-covered")));
  EXPECT_THAT(beyond.err, HasSubstr("20.0 mm (fit"));
}

// A page draws the bands that response.csv holds.
TEST_F(DrawsCommandLine, AFitHasBandsInItsTableAndItsPage) {
  EXPECT_THAT(ReadText(folder_ / "run/response.csv"), HasSubstr("gain_half_95_parameters,gain_half_95_measured"));
  EXPECT_THAT(ReadText(folder_ / "run/report.html"), HasSubstr("\"gain_bands\":["));
}

TEST_F(DrawsCommandLine, AreRefusedWithoutWhatTheyNeed) {
  EXPECT_THAT(Run("draws run --noise-only").err, HasSubstr("[draws-without-study]"));
  EXPECT_THAT(Run("draws run --study car/study.yaml --noise-only -n 2 -o draws.txt").err, HasSubstr("--output"));
  ReplaceIn("car/study.yaml", "file: stepped_sine.csv", "file: other.csv");
  const std::string recording = ReadText(folder_ / "car/stepped_sine.csv");
  // Ten times the first gain.
  temporary_.Write("car/other.csv", Replace(recording, ",1.18668,", ",11.8668,"));
  EXPECT_THAT(Run("draws run --study car/study.yaml --noise-only").err, HasSubstr("[draws-other-cost]"));
  ReplaceIn("run/result.json", "\"covariance\"", "\"formerly\"");
  EXPECT_THAT(Run("draws run").err, HasSubstr("[run-without-covariance]"));
}

}  // namespace
}  // namespace fourpost
