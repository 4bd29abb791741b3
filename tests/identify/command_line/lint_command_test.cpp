// What `fourpost fit` says of recordings of four posts that cannot be right.
#include <filesystem>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/identify/program.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

constexpr const char* kFit = "fit --no-suggest studies/landrover110/model1.yaml -o run";

class LintCommandLine : public ProgramTest {};

TEST_F(LintCommandLine, AFitSaysNothingOfLoadsThatAreRight) {
  const Outcome outcome = Run(kFit);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(Not(HasSubstr("[load-")), Not(HasSubstr("[loads-"))));
}

/// A load cell's value, and another one [N].
using Changes = std::vector<std::pair<const char*, const char*>>;

/// Fits of Models 1 and 3: loads of axles, and of corners.
class LoadLintCommandLine : public ProgramTest, public testing::WithParamInterface<const char*> {
 protected:
  Outcome FitWith(const Changes& changes) const {
    for (const auto& [right, wrong] : changes) ReplaceIn("studies/landrover110/static.csv", right, wrong);
    return Run(std::string("fit --no-suggest studies/landrover110/") + GetParam() + ".yaml -o run");
  }

  bool IsPlanar() const { return std::string(GetParam()) == "model1"; }
};

TEST_P(LoadLintCommandLine, WheelpansWeighedAlongAreWithinTheRangeThatIsTold) {
  // 25 kg each, 100 kg in all.
  const Outcome outcome = FitWith({{"4971", "5216"}, {"5092", "5337"}, {"5493", "5738"}, {"5497", "5742"}});
  // What loads and channels say against each other speaks against the fit.
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("[rig-"));
  const std::regex told(
      "add up to 2247 kg, .* so between (\\d+) and (\\d+) kg in all .*\\[loads-heavier-than-motion\\]");
  std::smatch range;
  ASSERT_TRUE(std::regex_search(outcome.err, range, told)) << outcome.err;
  EXPECT_LT(std::stod(range[1]), 100);
  EXPECT_GT(std::stod(range[2]), 100);
  // A model that lacks friction has wrong masses as well, and Model 1 is known to.
  if (IsPlanar()) {
    EXPECT_THAT(outcome.err, HasSubstr("first add what the model lacks"));
  }
  const Json warnings = Json::parse(ReadText(folder_ / "run/result.json"))["warnings"];
  EXPECT_THAT(warnings.dump(), HasSubstr("loads-heavier-than-motion"));
}

TEST_P(LoadLintCommandLine, OneLoadCellThatIsOffIsNamedByItsTyre) {
  // 1000 N more front left, the corner of which the fit hides most.
  const Outcome outcome = FitWith({{"4971", "5971"}});
  // What loads and channels say against each other speaks against the fit.
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("[rig-"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("[loads-")));
  EXPECT_THAT(outcome.err, HasSubstr("[load-far-off]"));
  EXPECT_THAT(outcome.err, HasSubstr(IsPlanar() ? "'front_tyre' fitted" : "'tyre_FL' fitted"));
  EXPECT_THAT(outcome.err, HasSubstr(IsPlanar() ? "measured 11060 N" : "measured 5971 N"));
}

INSTANTIATE_TEST_SUITE_P(Models, LoadLintCommandLine, testing::Values("model1", "model3"),
                         [](const auto& model) { return std::string(model.param); });

TEST_F(LintCommandLine, AFitRefusesPostsThatAreSurelyWrong) {
  ReplaceIn("studies/landrover110/model1.yaml", "posts: pitch", "posts: heave");
  const Outcome refused = Run(kFit);
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("[posts-contradict-study]"), HasSubstr("[posts-move-otherwise]"),
                                 HasSubstr("--accept-implausible")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
  const Outcome forced = Run(std::string(kFit) + " --accept-implausible --json");
  EXPECT_THAT(forced.err, HasSubstr("[posts-move-otherwise]"));
  EXPECT_THAT(Json::parse(forced.out)["warnings"].dump(), HasSubstr("posts-move-otherwise"));
}

}  // namespace
}  // namespace fourpost
