#include "identify/search/idle_parameters.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <gmock/gmock.h>

#include "identify/search/findings.h"
#include "tests/findings.h"
#include "tests/identify/test_problems.h"

namespace fourpost::idle_parameters_test {
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
  const auto found = [](std::function<Evaluation(const Eigen::VectorXd&)> evaluate) {
    Archive archive({Lattice({{"a", 0, 10, 0.1}, {"b", 0, 10, 0.1}}), std::move(evaluate)});
    Diagnostics diagnostics;
    CheckEffects(archive, "s.yaml", diagnostics);
    return diagnostics;
  };
  const Diagnostics constant = found([](const Eigen::VectorXd&) { return OneResidual(3); });
  EXPECT_THAT(constant, Reports(kObjectiveConstant, 0));
  EXPECT_EQ(constant.items().at(0).place.file, "s.yaml");
  EXPECT_THAT(found([](const Eigen::VectorXd& p) { return OneResidual(p[0]); }),
              Reports(kObjectiveIgnores, 0, {"'b'"}));
  EXPECT_EQ(found([](const Eigen::VectorXd& p) { return OneResidual(p.sum()); }).Format(), "");
}

}  // namespace
}  // namespace fourpost::idle_parameters_test
