#include "identify/search/idle_parameters.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <gmock/gmock.h>

#include "tests/identify/test_problems.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> IdleOf(std::function<Evaluation(const Eigen::VectorXd&)> evaluate) {
  Archive archive({Lattice({{"a", 0, 10, 0.1}, {"b", 0, 10, 0.1}, {"c", 0, 1, 0.5}}), std::move(evaluate)});
  return IdleParameters(archive);
}

TEST(IdleParameters, NamesAParameterWithoutEffect) {
  EXPECT_THAT(IdleOf([](const Eigen::VectorXd& p) { return OneResidual(p[0] + p[2]); }), ElementsAre("b"));
}

TEST(IdleParameters, NamesAllOfAConstantObjective) {
  EXPECT_THAT(IdleOf([](const Eigen::VectorXd&) { return OneResidual(3); }), ElementsAre("a", "b", "c"));
}

TEST(IdleParameters, NamesNoneThatActs) {
  EXPECT_THAT(IdleOf([](const Eigen::VectorXd& p) { return OneResidual(p.sum()); }), IsEmpty());
  // Only beyond a knee.
  EXPECT_THAT(IdleOf([](const Eigen::VectorXd& p) { return OneResidual(p[0] + std::max(p[1], 7.0) + p[2]); }),
              IsEmpty());
}

TEST(IdleParameters, NamesNoneWhereNothingCanBeEvaluated) {
  EXPECT_THAT(IdleOf([](const Eigen::VectorXd&) { return OneResidual(std::nan("")); }), IsEmpty());
}

TEST(IdleParameters, NamesNoneOfTheTestProblems) {
  for (const Problem& problem : {GearTrain(), MassSpringDamper()}) {
    Archive archive(problem);
    EXPECT_THAT(IdleParameters(archive), IsEmpty());
  }
}

TEST(CheckEffects, NamesAConstantObjectiveAndAnIdleParameter) {
  const auto told = [](std::function<Evaluation(const Eigen::VectorXd&)> evaluate) {
    Archive archive({Lattice({{"a", 0, 10, 0.1}, {"b", 0, 10, 0.1}}), std::move(evaluate)});
    Diagnostics diagnostics;
    CheckEffects(archive, "s.yaml", diagnostics);
    return diagnostics.Format();
  };
  using testing::HasSubstr;
  EXPECT_THAT(told([](const Eigen::VectorXd&) { return OneResidual(3); }),
              HasSubstr("s.yaml: error: the objective is constant: no parameter has an effect on it"));
  EXPECT_THAT(told([](const Eigen::VectorXd& p) { return OneResidual(p[0]); }),
              HasSubstr("s.yaml: warning: parameter 'b' has no effect on the objective: fix it"));
  EXPECT_EQ(told([](const Eigen::VectorXd& p) { return OneResidual(p.sum()); }), "");
}

}  // namespace
}  // namespace fourpost
