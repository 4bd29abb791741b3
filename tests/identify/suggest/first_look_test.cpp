#include "identify/suggest/first_look.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "identify/study/loaded_study.h"
#include "identify/suggest/addition_list.h"

namespace fourpost::first_look_test {
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

/// Beside the others; residuals of its own, which nothing but an evaluation gives.
class Weighing : public Experiment {
 public:
  explicit Weighing(std::function<Evaluation(const Deadline&)> weigh) : weigh_(std::move(weigh)) {}
  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<Weighing>(weigh_); }
  std::optional<ResidualBlock> Residuals(const Subject&) const override {
    return ResidualBlock{
        .name = "weighing",
        .count = 1,
        .evaluate = [weigh = weigh_](const std::vector<double>&, const Deadline& deadline) { return weigh(deadline); }};
  }
  std::vector<ExperimentFile> Files() const override { return {}; }
  void Load(const Subject&, Diagnostics&) override {}
  void AddTo(Sha256&, Sha256&) const override {}
  bool MeasuresForce() const override { return false; }
  ExperimentResults Results(const Subject&, const FitResult&) const override { return {}; }
  std::optional<ExperimentResults> Respond(const Subject&, std::optional<Engine>, const WorkHooks&) const override {
    return std::nullopt;
  }
  std::string_view Recordings() const override { return ""; }
  bool Reads(const RecordedTable&) const override { return false; }
  std::optional<ExperimentResults> Predict(const Subject&, const PredictionRequest&, const WorkHooks&) const override {
    return std::nullopt;
  }

 private:
  std::function<Evaluation(const Deadline&)> weigh_;
};

class FirstLookBeside : public testing::Test {
 protected:
  FirstLookBeside() {
    Diagnostics findings;
    study_ = LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110/model1.yaml", findings);
    if (study_) study_->Prepare();
  }

  /// Of two additions, with this experiment beside those of the study.
  std::vector<std::optional<Eigen::VectorXd>> Look(std::function<Evaluation(const Deadline&)> weigh) {
    study_->study.experiments.Add(std::make_unique<Weighing>(std::move(weigh)));
    const VehicleObjective objective = study_->MakeObjective();
    const Eigen::VectorXd values = objective.FileValues();
    const Eigen::VectorXd here = objective.Evaluate(values).residuals;
    const std::vector<Addition> additions = AllAdditions(*study_, objective.AllParameters(values));
    std::vector<std::unique_ptr<AugmentedStudy>> augmented;
    std::vector<FirstLook> looks;
    for (const Addition& addition : additions) {
      if (addition.mechanism != "friction" || looks.size() == 2) continue;
      augmented.push_back(std::make_unique<AugmentedStudy>(*study_, addition, true));
      looks.push_back({augmented.back().get(), addition.first});
    }
    began_ = true;
    return LookAt(objective, values, here, looks);
  }

  static Evaluation Good() { return {.residuals = Eigen::VectorXd::Zero(1)}; }

  std::optional<LoadedStudy> study_;
  /// Whether the look has.
  bool began_ = false;
};

TEST_F(FirstLookBeside, EvaluatesNoLongerThanTheStudyAllows) {
  ASSERT_TRUE(study_);
  study_->study.search.deadline_s = 1e-9;
  const auto seen = Look([&](const Deadline& deadline) {
    if (began_) deadline.Check();
    return Good();
  });
  EXPECT_THAT(seen, testing::ElementsAre(std::nullopt, std::nullopt));
}

// Which is then evaluated, as the first one is here.
TEST_F(FirstLookBeside, LeavesOutAnAdditionThatThrows) {
  ASSERT_TRUE(study_);
  int calls = 0;
  const auto seen = Look([&](const Deadline&) {
    // Of both together, then of each alone.
    if (began_ && ++calls <= 2) throw std::logic_error("no such car");
    return Good();
  });
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_FALSE(seen[0]);
  EXPECT_TRUE(seen[1]);
}

INSTANTIATE_TEST_SUITE_P(Studies, FirstLookAt,
                         testing::Values("landrover110/model1.yaml", "single_wheel_station/model2.yaml"),
                         [](const auto& instance) { return std::to_string(instance.index); });

}  // namespace
}  // namespace fourpost::first_look_test
