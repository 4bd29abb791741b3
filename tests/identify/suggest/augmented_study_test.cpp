#include "identify/suggest/augmented_study.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "identify/suggest/addition_list.h"
#include "tests/identify/shipped_study.h"

namespace fourpost::augmented_study_test {
namespace {

// Nothing holds the rod of a damper on its bench, and its gas pushes it out.
TEST(AugmentedStudy, EvaluatesWhatIsAddedToADamperOnItsBench) {
  LoadedStudy study = ShippedStudy("../damper/model2");
  study.Prepare();
  const VehicleObjective objective = study.MakeObjective();
  const Eigen::VectorXd values = objective.FileValues();
  const std::vector<Addition> additions = AllAdditions(study, objective.AllParameters(values));
  const auto gas = std::find_if(additions.begin(), additions.end(),
                                [](const Addition& addition) { return addition.mechanism == "gas"; });
  ASSERT_NE(gas, additions.end());
  const AugmentedStudy augmented(study, *gas, true);
  const auto there = augmented.At(gas->first, values);
  ASSERT_TRUE(there) << augmented.failure();
  EXPECT_GT((*there - objective.Evaluate(values).residuals).norm(), 1);
}

}  // namespace
}  // namespace fourpost::augmented_study_test
