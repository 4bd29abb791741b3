#include "identify/run/growth_path.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fourpost::growth_path_test {
namespace {

namespace fs = std::filesystem;

/// A study, an addition that was kept, one that was refused, and one that is still to be tried.
GrowthPath Path() {
  GrowthPath path{.study = "study.yaml", .state = "digest"};
  path.steps = {{.folder = "steps/0", .cost = 1000.1, .misfit = 3, .validation_percent = NAN, .is_kept = true},
                {.addition = {.words = "a mount", .variant = 3, .amount = 1e-6, .count = 1, .parameters = {"k"}},
                 .folder = "steps/1",
                 .cost = 0.1 + 0.2,
                 .criterion = -7,
                 .effective = 33.5,
                 .residuals = 100,
                 .tried = 29,
                 .is_kept = true},
                {.addition = {.words = "friction"},
                 .folder = "steps/2",
                 .cost = 1 / 3.0,
                 .criterion = 4,
                 .at_bound = {"v"},
                 .reason = "dear"}};
  path.round =
      GrowthRound{.candidates = {{.addition = {.words = "friction"}, .folder = "steps/2"},
                                 {.addition = {.words = "gas", .count = 2, .choices = 2, .parameters = {"v", "c"}},
                                  .folder = "steps/3",
                                  .effective = 40.5}},
                  .residuals = 100,
                  .tried = 30,
                  .first = 2};
  return path;
}

class GrowthPathTest : public testing::Test {
 protected:
  GrowthPathTest() {
    output_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(output_);
    const GrowthPath path = Path();
    for (const GrowthStep& step : path.steps) {
      std::ostringstream cost;
      cost.precision(17);
      cost << step.cost;
      Write(step.folder + "/fit/result.json", "{\"cost\": " + cost.str() + "}");
    }
    for (const GrowthCandidate& one : path.round->candidates)
      for (const char* name : {"/study.yaml", "/vehicle.urdf"}) Write(one.folder + name, "");
  }
  ~GrowthPathTest() override { fs::remove_all(output_); }

  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories((output_ / name).parent_path());
    std::ofstream(output_ / name) << text;
  }

  GrowthPath Again(const GrowthPath& path, const std::string& state = "digest") const {
    Write("steps/growth.json", GrowthJson(path));
    return EarlierGrowth(output_, state);
  }

  fs::path output_;
};

TEST_F(GrowthPathTest, IsReadAsItWasWritten) {
  const GrowthPath path = Path();
  const GrowthPath again = Again(path);
  EXPECT_EQ(GrowthJson(again), GrowthJson(path));
  ASSERT_EQ(again.steps.size(), 3u);
  EXPECT_TRUE(std::isnan(again.steps[0].validation_percent));
  ASSERT_TRUE(again.round);
  EXPECT_EQ(again.TriedOfRound(), 1u);
  EXPECT_EQ(again.round->candidates[1].effective, 40.5);
  EXPECT_EQ(again.steps[1].addition.amount, 1e-6);
}

TEST_F(GrowthPathTest, OfAVersionThatChargedAllAlikeIsRead) {
  nlohmann::json written = nlohmann::json::parse(GrowthJson(Path()));
  for (nlohmann::json& step : written["steps"]) step.erase("choices");
  for (nlohmann::json& one : written["round"]["candidates"]) one.erase("choices");
  Write("steps/growth.json", written.dump());
  const GrowthPath again = EarlierGrowth(output_, "digest");
  ASSERT_EQ(again.steps.size(), 3u);
  EXPECT_EQ(again.steps[1].addition.choices, 1);
}

TEST_F(GrowthPathTest, NumbersStepsByWhatWasKept) {
  GrowthPath path = Path();
  path.steps.push_back({.addition = {.words = "gas"}, .folder = "steps/3", .is_kept = true});
  EXPECT_EQ(path.NumberOf(0), 0u);
  EXPECT_EQ(path.NumberOf(1), 1u);
  EXPECT_EQ(path.NumberOf(2), 2u);
  EXPECT_EQ(path.NumberOf(3), 2u);
  EXPECT_EQ(path.Added(), (std::vector<std::string>{"a mount", "gas"}));
  EXPECT_EQ(path.LastKept(), 3u);
}

TEST_F(GrowthPathTest, KnowsWhatStandsAfterSomethingWasTakenBack) {
  GrowthPath path = Path();
  path.steps.push_back({.addition = {.words = "gas"}, .folder = "steps/3", .is_kept = true});
  GrowthStep back{.addition = {.words = "a mount"}, .takes_back = "steps/1", .folder = "steps/4"};
  path.steps.push_back(back);
  EXPECT_EQ(path.Added(), (std::vector<std::string>{"a mount", "gas"}));
  EXPECT_FALSE(path.TakenBackBy(1));
  path.steps.back().is_kept = true;
  EXPECT_EQ(path.Added(), std::vector<std::string>{"gas"});
  EXPECT_EQ(path.TakenBack(), std::vector<std::string>{"a mount"});
  EXPECT_EQ(path.Standing(), std::vector<std::size_t>{3});
  EXPECT_EQ(path.TakenBackBy(1), 3u);
  EXPECT_EQ(path.LastKept(), 4u);
}

TEST_F(GrowthPathTest, TakesBackAScaleAsOftenAsItWasAdded) {
  GrowthPath path = Path();
  path.steps.push_back({.addition = {.words = "a mount"}, .folder = "steps/3", .is_kept = true});
  EXPECT_EQ(path.Standing(), (std::vector<std::size_t>{1, 3}));
  path.steps.push_back(
      {.addition = {.words = "a mount"}, .takes_back = "steps/1", .folder = "steps/4", .is_kept = true});
  EXPECT_TRUE(path.Standing().empty());
  EXPECT_EQ(path.TakenBackBy(3), 3u);
  EXPECT_FALSE(path.TakenBackBy(4));
}

TEST_F(GrowthPathTest, KeepsWhyItEndedWhileItTakesBack) {
  GrowthPath path = Path();
  path.end = "nothing more pays";
  EXPECT_EQ(Again(path).end, "nothing more pays");
  EXPECT_FALSE(Again(path).is_over);
}

TEST_F(GrowthPathTest, OfAnotherStateIsNone) {
  EXPECT_TRUE(Again(Path(), "other").steps.empty());
  Write("steps/growth.json", R"({"state": "digest", "steps": [{"added": 1}]})");
  EXPECT_TRUE(EarlierGrowth(output_, "digest").steps.empty());
  Write("steps/growth.json", "[");
  EXPECT_TRUE(EarlierGrowth(output_, "digest").steps.empty());
}

TEST_F(GrowthPathTest, EndsBeforeAStepWhoseResultIsLost) {
  GrowthPath path = Path();
  path.end = "nothing more pays";
  path.is_over = true;
  EXPECT_TRUE(Again(path).is_over);
  Write("steps/1/fit/result.json", "{\"cost\": 5}");
  const GrowthPath again = Again(path);
  EXPECT_EQ(again.steps.size(), 1u);
  EXPECT_FALSE(again.round);
  EXPECT_FALSE(again.is_over);
  EXPECT_EQ(again.end, "");
}

TEST_F(GrowthPathTest, OfALostRoundKnowsWhatWasKept) {
  fs::remove(output_ / "steps/3/vehicle.urdf");
  const GrowthPath again = Again(Path());
  EXPECT_EQ(again.steps.size(), 2u);
  EXPECT_FALSE(again.round);
}

TEST_F(GrowthPathTest, RemembersAnAdditionThatCouldNotBeFitted) {
  GrowthPath path = Path();
  path.steps[2].cost = NAN;
  fs::remove_all(output_ / "steps/2/fit");
  EXPECT_EQ(Again(path).steps.size(), 3u);
}

}  // namespace
}  // namespace fourpost::growth_path_test
