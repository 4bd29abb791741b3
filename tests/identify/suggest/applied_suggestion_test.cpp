#include "identify/suggest/applied_suggestion.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "identify/refine/robust_loss.h"
#include "tests/temporary_folder.h"

namespace fourpost::applied_suggestion_test {
namespace {

LoadedStudy Prepared(const std::filesystem::path& file) {
  LoadedStudy study = LoadSoundStudy(file);
  study.Prepare();
  return study;
}

double CostAtFileValues(const LoadedStudy& study) {
  const VehicleObjective objective = study.MakeObjective();
  const LossKind kind = study.study.refine.loss;
  const RobustLoss loss(kind, study.study.refine.scale.value_or(UsualScale(kind)), objective.prior_count());
  return loss.Cost(objective.Evaluate(objective.FileValues()).residuals);
}

class AppliedSuggestionTest : public testing::Test {
 protected:
  AppliedSuggestionTest()
      : study_(Prepared(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110/model1.yaml")),
        values_(study_.MakeObjective().FileValues()),
        found_(SuggestFor(study_, values_, 2, {})) {}

  LoadedStudy study_;
  Eigen::VectorXd values_;
  Suggestions found_;
};

// The cost that it states is that of an evaluation at parameters that have followed: those are written, in six digits,
// which at slopes of the cost by its parameters of some times the cost is far below a thousandth.
TEST_F(AppliedSuggestionTest, BeginsWhereTheSuggestionWasEvaluated) {
  const TemporaryFolder folder;
  int seen = 0;
  for (const SuggestedAddition& one : found_.list) {
    // What was not confirmed begins at the old values; corrections of channels have fewer digits.
    if (one.others == values_ || one.addition.study) continue;
    ++seen;
    EXPECT_LT(one.cost, found_.cost);
    const AppliedSuggestion applied = Apply(study_, one, folder.path());
    std::ofstream(folder.path() / "vehicle.urdf") << applied.vehicle;
    std::ofstream(folder.path() / "study.yaml") << applied.study;
    EXPECT_NEAR(CostAtFileValues(Prepared(folder.path() / "study.yaml")), one.cost, 1e-3 * one.cost)
        << one.addition.words;
  }
  EXPECT_GE(seen, 3);
}

}  // namespace
}  // namespace fourpost::applied_suggestion_test
