// What `fourpost fit` says of recordings of four posts that cannot be right.
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

constexpr const char* kFit = "fit studies/landrover110/model1.yaml -o run";

class LintCommandLine : public ProgramTest {};

TEST_F(LintCommandLine, AFitSaysNothingOfLoadsThatAreRight) {
  const Outcome outcome = Run(kFit);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(Not(HasSubstr(" carries ")), Not(HasSubstr("static loads add up"))));
}

TEST_F(LintCommandLine, AFitTellsOfWheelpansThatWereWeighedAlong) {
  // 25 kg each.
  for (const auto& [right, wrong] : {std::pair{"4971", "5216"}, {"5092", "5337"}, {"5493", "5738"}, {"5497", "5742"}})
    ReplaceIn("studies/landrover110/static.csv", right, wrong);
  const Outcome outcome = Run(kFit);
  EXPECT_EQ(outcome.code, 0);
  // What the model misses of forces in motion, 92 kg of the right loads, is in this.
  EXPECT_THAT(outcome.err, testing::ContainsRegex("static.csv: warning: the static loads add up to 2247 kg, forces in "
                                                  "motion alone tell 20[56][0-9] kg .sd 20.: some 4[5-8] kg on each "
                                                  "of 4 loads are weighed along or not tared, such as wheelpans"));
  const Json warnings = Json::parse(ReadText(folder_ / "run/result.json"))["warnings"];
  EXPECT_THAT(warnings.dump(), HasSubstr("such as wheelpans"));
}

TEST_F(LintCommandLine, AFitRefusesPostsThatAreSurelyWrong) {
  ReplaceIn("studies/landrover110/model1.yaml", "posts: pitch", "posts: heave");
  const Outcome refused = Run(kFit);
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("error: recording 'pitch' is told to be of posts that move as heave"),
                                 HasSubstr("--accept-implausible fits all the same")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
  const Outcome forced = Run(std::string(kFit) + " --accept-implausible --json");
  EXPECT_THAT(forced.err, HasSubstr("warning: recording 'pitch' is told to be of posts that move as heave"));
  EXPECT_THAT(Json::parse(forced.out)["warnings"].dump(), HasSubstr("is told to be of posts"));
}

}  // namespace
}  // namespace fourpost
