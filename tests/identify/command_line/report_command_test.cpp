// `fourpost report` as a user meets it.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class ReportCommandLine : public ProgramTest {
 protected:
  void Fit() {
    const Outcome outcome = Run("fit --no-suggest studies/landrover110/model2.yaml -o run");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
};

TEST_F(ReportCommandLine, WritesWhatTheFitWrote) {
  Fit();
  const std::string page = ReadText(folder_ / "run/report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<h1>landrover110_linkage</h1>"), HasSubstr("The fit converged."),
                          HasSubstr("<code>c_front_bump</code>"), HasSubstr("rear hop")));
  const Outcome outcome = Run("report run -o again.html --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["bytes"], std::filesystem::file_size(folder_ / "again.html"));
  // The fitted vehicle comes from its file here, in whose digits nothing is lost.
  EXPECT_TRUE(ReadText(folder_ / "again.html") == page);
}

// Between clamps nothing has to hold the rod, and there is nothing to see.
TEST_F(ReportCommandLine, ShowsADamperWithoutItsVehicle) {
  const Outcome outcome = Run("fit studies/damper/model2.yaml -o run");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("equilibrium"), std::string::npos) << outcome.err;
  EXPECT_THAT(ReadText(folder_ / "run/report.html"), AllOf(HasSubstr("Damper bench"), Not(HasSubstr("equilibrium")),
                                                           Not(HasSubstr("The vehicle is not shown"))));
}

TEST_F(ReportCommandLine, ShowsARunWhoseVehicleIsGone) {
  Fit();
  std::filesystem::remove(folder_ / "run/vehicle.urdf");
  const Outcome outcome = Run("report run");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("vehicle.urdf"), HasSubstr("[vehicle-not-shown]")));
  EXPECT_THAT(ReadText(folder_ / "run/report.html"), Not(HasSubstr("data-draw=\"viewer\"")));
}

TEST_F(ReportCommandLine, SaysWhatItNeeds) {
  std::filesystem::create_directory(folder_ / "empty");
  Outcome outcome = Run("report empty");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("empty: error: "), HasSubstr("[run-empty]")));
  outcome = Run("report urdf/quarter_car.urdf");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("[run-not-there]"));
  ASSERT_EQ(Run("modes urdf/quarter_car.urdf -o modes").code, 0);
  outcome = Run("report modes");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("[result-not-of-fit]"));
  temporary_.Write("empty/result.json", "{");
  EXPECT_THAT(Run("report empty").err, HasSubstr("[result-not-json]"));
}

TEST_F(ReportCommandLine, ComparesRuns) {
  for (const char* model : {"model1", "model2"})
    ASSERT_EQ(Run(std::string("fit studies/damper/") + model + ".yaml -o " + model).code, 0);
  Outcome outcome = Run("report model1 model2 -o models.html --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["bytes"], std::filesystem::file_size(folder_ / "models.html"));
  const std::string page = ReadText(folder_ / "models.html");
  // What `fourpost rank` says of them.
  const Json rank = Json::parse(Run("rank model1 model2 --json").out);
  EXPECT_THAT(page, AllOf(HasSubstr("2 fits compared"), HasSubstr("Recommended: " + rank["reason"].get<std::string>()),
                          HasSubstr("data-draw=\"compared_bench\""), HasSubstr("damper bench")));
}

TEST_F(ReportCommandLine, SaysWhatAComparisonNeeds) {
  Outcome outcome = Run("report one two");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--output: error: "), HasSubstr(" 2 "), HasSubstr("[page-without-name]")));
  std::filesystem::create_directory(folder_ / "one");
  outcome = Run("report one two -o models.html");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("one: error: "), HasSubstr("[run-empty]")));
  temporary_.Write("one/result.json", "{}");
  EXPECT_THAT(Run("report one one -o models.html").err,
              AllOf(HasSubstr("one/result.json: error: "), HasSubstr("[result-not-of-fit]")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "models.html"));
}

TEST_F(ReportCommandLine, NamesTheRunThatItDoesNotUnderstand) {
  ASSERT_EQ(Run("fit studies/damper/model1.yaml -o good").code, 0);
  const Json good = Json::parse(ReadText(folder_ / "good/result.json"));
  const auto bad = [&](const std::string& key, const Json& value) {
    Json json = good;
    json[key] = value;
    temporary_.Write("bad/result.json", json.dump());
    return Run("report good bad -o models.html");
  };
  std::filesystem::create_directory(folder_ / "bad");
  for (const auto& [key, value] : {std::pair<std::string, Json>{"refine", 1}, {"static_loads", Json::array({1})}}) {
    const Outcome outcome = bad(key, value);
    EXPECT_EQ(outcome.code, 3) << key << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad/result.json: error: "), HasSubstr("[result-not-understood]"),
                                   Not(HasSubstr("good/"))));
  }
  temporary_.Write("bad/bench.csv", "time_s\n0\n");
  EXPECT_THAT(bad("seed", 2).err,
              AllOf(HasSubstr("bad/bench.csv:1: error: "), HasSubstr("'recording': fit again [fit-column-missing]")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "models.html"));
}

TEST_F(ReportCommandLine, KeepsAnOlderReportOnAFullDisk) {
  Fit();
  const std::string before = ReadText(folder_ / "run/report.html");
  // A limit of 100 blocks of 512 bytes stands for a full disk.
  const Outcome outcome = RunShell(std::string("ulimit -f 100; '") + FOURPOST_PROGRAM + "' report run");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("[disk-full]"));
  EXPECT_TRUE(ReadText(folder_ / "run/report.html") == before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/report.html.partial"));
}

TEST_F(ReportCommandLine, DoesNotOverwriteWhatItReads) {
  Fit();
  EXPECT_EQ(Run("report run -o run/result.json").code, 5);
  EXPECT_THAT(ReadText(folder_ / "run/result.json"), HasSubstr("termination"));
}

}  // namespace
}  // namespace fourpost
