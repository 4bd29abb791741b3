#include "identify/suggest/first_look.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/study/loaded_study.h"
#include "identify/suggest/addition_list.h"

namespace fourpost {
namespace {

struct Case {
  const char* study;
  /// What evaluations leave where additions are small: of balances their own derivatives', see SolveBalanceSensitivity.
  double tolerance;
};

class FirstLookAt : public testing::TestWithParam<Case> {};

// Against the residuals of one hundredth of what is looked at first: to first order they change by as much each.
TEST_P(FirstLookAt, EachMechanismIsItsEvaluation) {
  constexpr double kShare = 0.01;
  Diagnostics findings;
  std::optional<LoadedStudy> study =
      LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies" / GetParam().study, findings);
  ASSERT_TRUE(study) << findings.Format();
  study->Prepare();
  const VehicleObjective objective = study->MakeObjective();
  const Eigen::VectorXd values = objective.FileValues();
  const Eigen::VectorXd here = objective.Evaluate(values).residuals;
  std::set<std::string> seen;
  for (const Addition& addition : AllAdditions(*study, objective.AllParameters(values))) {
    // Of each mechanism one; what lies beyond the motion does nothing, little as much.
    if (addition.study || !seen.insert(addition.mechanism).second) continue;
    const AugmentedStudy augmented(*study, addition, true);
    const double amount = kShare * addition.first;
    if (amount < addition.least) continue;
    const auto there = augmented.At(amount, values);
    ASSERT_TRUE(there) << addition.words << ": " << augmented.failure();
    const auto look = LookAt(objective, values, here, std::vector<FirstLook>{{&augmented, amount}}).front();
    if (!look) {
      // It has coordinates of its own.
      EXPECT_TRUE(addition.mechanism == "part_on_mounts" || addition.mechanism == "mount") << addition.words;
      continue;
    }
    const Eigen::VectorXd change = *there - here;
    EXPECT_LE((*look - *there).norm(), GetParam().tolerance * change.norm() + 1e-6 * here.norm()) << addition.words;
  }
  EXPECT_GE(seen.size(), 6u);
}

INSTANTIATE_TEST_SUITE_P(Studies, FirstLookAt,
                         testing::Values(Case{"landrover110/model1.yaml", 0.05},
                                         Case{"single_wheel_station/model2.yaml", 0.02}),
                         [](const auto& instance) { return std::to_string(instance.index); });

}  // namespace
}  // namespace fourpost
