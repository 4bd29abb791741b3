#include "identify/suggest/first_look.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "identify/study/loaded_study.h"
#include "identify/suggest/addition_list.h"

namespace fourpost {
namespace {

class FirstLookAt : public testing::TestWithParam<const char*> {};

// Against evaluations at three and six thousandths of what is looked at first, by the change between the two: a balance
// with friction takes other samples than one without, which moves residuals by 1e-4 whatever the amount. At such
// amounts friction, the worst, is 6 % beyond first order, and in proportion to the amount.
TEST_P(FirstLookAt, EachMechanismIsItsEvaluation) {
  constexpr double kShare = 0.003;
  constexpr double kSecondOrder = 0.1;
  Diagnostics findings;
  std::optional<LoadedStudy> study =
      LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies" / GetParam(), findings);
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
    const auto beyond = augmented.At(2 * amount, values);
    ASSERT_TRUE(there && beyond) << addition.words << ": " << augmented.failure();
    const auto look = LookAt(objective, values, here, std::vector<FirstLook>{{&augmented, amount}}).front();
    if (!look) {
      EXPECT_THAT(addition.mechanism, testing::AnyOf("part_on_mounts", "mount", "hysteresis"))
          << addition.words << ": only what has states of its own is not seen";
      continue;
    }
    const Eigen::VectorXd change = *beyond - *there;
    EXPECT_LE((*look - here - change).norm(), kSecondOrder * change.norm() + 1e-6 * here.norm()) << addition.words;
  }
  EXPECT_GE(seen.size(), 6u);
}

INSTANTIATE_TEST_SUITE_P(Studies, FirstLookAt,
                         testing::Values("landrover110/model1.yaml", "single_wheel_station/model2.yaml"),
                         [](const auto& instance) { return std::to_string(instance.index); });

}  // namespace
}  // namespace fourpost
