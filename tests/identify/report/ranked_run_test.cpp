#include "identify/report/ranked_run.h"

#include <gmock/gmock.h>

#include "identify/report/findings.h"
#include "identify/study/experiment_kinds.h"
#include "identify/uncertainty/findings.h"
#include "tests/findings.h"

namespace fourpost::ranked_run_test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class FittedModelsTest : public testing::Test {
 protected:
  FittedModelsTest() {
    good_ = Json::parse(R"({"study": "model1.yaml", "termination": "converged", "parameters": [], "residuals": 100,
      "channels": [{"recording": "sweep", "name": "force", "nmse_percent": 2}],
      "validation": [{"recording": "s1", "name": "force", "nmse_percent": 3},
                     {"recording": "s2", "name": "force", "nmse_percent": 5}],
      "fitted_files": [{"name": "sweep.csv", "sha256": "01"}],
      "validation_files": [{"name": "s1.csv", "sha256": "02"}, {"name": "s2.csv", "sha256": "03"}],
      "criteria": {"residuals": 100, "parameters": 2, "aicc": 7, "bic": 8}})");
    other_ = good_;
    other_["study"] = "model2.yaml";
  }

  std::vector<FittedModel> Models() {
    const auto run = [](const std::string& folder, const Json& result, const std::string& study) {
      return std::pair{folder, RunContents{.files = {{"result.json", result.dump()}, {"study.yaml", study}}}};
    };
    return FittedModels(
        ComparedRuns({run("a", good_, "bench: {columns: 2}"), run("b", other_, other_study_)}, AllExperimentReports()),
        diagnostics_);
  }

  Json good_;
  Json other_;
  std::string other_study_ = "bench: {columns: 2}";
  Diagnostics diagnostics_;
};

TEST_F(FittedModelsTest, AreReadFromTheirRuns) {
  const std::vector<FittedModel> models = Models();
  ASSERT_EQ(models.size(), 2) << diagnostics_.Format();
  EXPECT_EQ(models[0].name, "model1");
  EXPECT_EQ(models[1].name, "model2");
  EXPECT_EQ(models[0].fitted_percent, 2);
  EXPECT_EQ(models[0].validation_percent, 4);
  EXPECT_EQ(models[0].criteria.bic, 8);
}

TEST_F(FittedModelsTest, OfOneStudyAreToldApartByTheirFolders) {
  other_["study"] = "model1.yaml";
  const std::vector<FittedModel> models = Models();
  EXPECT_EQ(models[0].name, "model1 (a)");
  EXPECT_EQ(models[1].name, "model1 (b)");
}

TEST_F(FittedModelsTest, TellThatTheirFitsDidNotEnd) {
  other_["termination"] = "interrupted";
  const ModelRanking ranking = Rank(Models());
  EXPECT_THAT(ranking.warnings, Reports(kRankedInterrupted, 0, {"model2"}));
  EXPECT_EQ(ranking.warnings.items().size(), 1u) << ranking.warnings.Format();
}

TEST_F(FittedModelsTest, MustBeOfTheSameRecordings) {
  other_["validation"][1]["recording"] = "s3";
  Models();
  EXPECT_THAT(diagnostics_, Reports(kRunOfOtherData, 0, {"than a"}));
  EXPECT_EQ(diagnostics_.items().front().place.file, "b/result.json");
}

// A recording whose force was scaled keeps its name and its samples.
TEST_F(FittedModelsTest, MustBeOfTheSameBytes) {
  other_["fitted_files"][0]["sha256"] = "04";
  Models();
  EXPECT_THAT(diagnostics_, Reports(kRunOfOtherData, 0, {"than a"}));
}

TEST_F(FittedModelsTest, MayHaveTheirValidationInAnotherOrder) {
  std::swap(other_["validation"][0], other_["validation"][1]);
  std::swap(other_["validation_files"][0], other_["validation_files"][1]);
  Models();
  EXPECT_FALSE(diagnostics_.HasErrors()) << diagnostics_.Format();
}

TEST_F(FittedModelsTest, MustBeOfTheSameValidation) {
  other_["validation_files"][1]["sha256"] = "04";
  Models();
  EXPECT_THAT(diagnostics_, Reports(kRunOfOtherData, 0));
}

TEST_F(FittedModelsTest, MustTreatTheRecordingsAlike) {
  other_study_ = "bench: {columns: 2, low_pass: 60 Hz}";
  Models();
  EXPECT_THAT(diagnostics_, Reports(kRunOfOtherData, 0));
}

TEST_F(FittedModelsTest, MustBeOfBenches) {
  good_.erase("criteria");
  other_["criteria"] = nullptr;
  Models();
  EXPECT_EQ(diagnostics_.items().size(), 2);
  EXPECT_THAT(diagnostics_, Reports(kRunNotOfBench, 0));
}

}  // namespace
}  // namespace fourpost::ranked_run_test
