#include "identify/study/study_methods.h"

#include <fstream>

#include <gmock/gmock.h>

#include "identify/problems/test_problem.h"
#include "identify/study/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::study_methods_test {
namespace {

class StudyMethods : public testing::Test {
 protected:
  // The methods of these names in a study of the gear train with one method.
  std::vector<ComparedMethod> Read(const std::string& method, const std::vector<std::string>& names = {"mine"}) {
    diagnostics_ = {};
    std::ofstream(file_) << "problem: gear_train\nmethods:\n  mine: {" << method << "}\n";
    const std::optional<Study> study = ReadStudy(file_, diagnostics_);
    if (!study) return {};
    return MethodsOf(*study, names, MakeTestProblem("gear_train").problem, diagnostics_);
  }

  Diagnostics Fault(const std::string& method, const std::vector<std::string>& names = {"mine"}) {
    Read(method, names);
    EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
    return diagnostics_;
  }

  TemporaryFolder temporary_;
  std::filesystem::path file_ = temporary_.path() / "study.yaml";
  Diagnostics diagnostics_;
};

TEST_F(StudyMethods, ChangesSettingsOfAPreset) {
  const auto methods =
      Read("method: thesis, population: 33, base: random, factor: 0.8, forced_gene: true", {"de", "mine"});
  ASSERT_EQ(methods.size(), 2u) << diagnostics_.Format();
  const auto& options = std::get<DvhdeOptions>(methods[1].options);
  EXPECT_EQ(options.population, 33);
  EXPECT_EQ(options.base, MutationBase::kRandom);
  EXPECT_EQ(options.factor, 0.8);
  EXPECT_TRUE(options.forced_gene);
  // The rest is the preset's.
  EXPECT_EQ(options.crossover, ThesisDvhde().crossover);
  EXPECT_EQ(std::get<DvhdeOptions>(methods[0].options).population, 20);
}

TEST_F(StudyMethods, ReadsBackEverySettingItPrints) {
  const Problem problem = MakeTestProblem("oscillator").problem;
  for (const std::string_view name : kMethodNames) {
    Study study;
    study.methods = {{.name = "copy", .preset = std::string(name)}};
    const auto settings = Settings(MethodPreset(name, problem));
    for (const auto& [key, value] : settings) study.methods[0].settings.push_back({key, value});
    Diagnostics diagnostics;
    const auto methods = MethodsOf(study, {"copy"}, problem, diagnostics);
    ASSERT_FALSE(diagnostics.HasErrors()) << diagnostics.Format();
    EXPECT_EQ(Settings(methods[0].options), settings);
  }
}

TEST_F(StudyMethods, AFitExploresByTheMethodOfItsSearch) {
  const Problem problem = MakeTestProblem("oscillator").problem;
  Study study;
  // By default dvHDE, which accelerates by derivatives where it can.
  EXPECT_EQ(AlgorithmName(ExplorationOf(study, problem, diagnostics_)), "dvhde");
  EXPECT_EQ(std::get<DvhdeOptions>(ExplorationOf(study, problem, diagnostics_)).acceleration,
            Acceleration::kLeastSquares);
  study.search.method = "thesis";
  study.search.population = 33;
  const auto thesis = std::get<DvhdeOptions>(ExplorationOf(study, problem, diagnostics_));
  EXPECT_EQ(thesis.simplex_iterations, ThesisDvhde().simplex_iterations);
  EXPECT_EQ(thesis.population, 33);
  EXPECT_FALSE(diagnostics_.HasErrors()) << diagnostics_.Format();
}

TEST_F(StudyMethods, AFitRefusesMethodsThatOnlyRefineAndUnknownOnes) {
  const Problem problem = MakeTestProblem("oscillator").problem;
  Study study;
  study.file = "study.yaml";
  study.search.method_line = 7;
  study.search.method = "gb";
  ExplorationOf(study, problem, diagnostics_);
  EXPECT_THAT(diagnostics_, Reports(kMethodOnlyRefines, 7, {"'gb'"}));
  EXPECT_EQ(diagnostics_.items().at(0).place.file, "study.yaml");
  diagnostics_ = {};
  study.search.method = "dvhd";
  ExplorationOf(study, problem, diagnostics_);
  EXPECT_THAT(diagnostics_, Reports(kMethodUnknown, 7, {"'dvhd'", "'dvhde'"}));
  EXPECT_EQ(diagnostics_.items().at(0).place.file, "study.yaml");
}

TEST_F(StudyMethods, ReadsFormerNamesWithAWarning) {
  const Problem problem = MakeTestProblem("oscillator").problem;
  const auto methods = MethodsOf(Study(), {"ds", "cma"}, problem, diagnostics_);
  ASSERT_EQ(methods.size(), 2u);
  EXPECT_EQ(methods[0].name, "simplex");
  EXPECT_EQ(AlgorithmName(methods[1].options), "cmaes");
  EXPECT_FALSE(diagnostics_.HasErrors());
  EXPECT_THAT(diagnostics_, ReportsOption(kMethodFormer, "--methods", {"'ds'", "'simplex'"}));
}

TEST_F(StudyMethods, NamesFaultsWithTheirLine) {
  EXPECT_THAT(Fault("method: thesis, popluation: 33"),
              Reports(kSettingUnknown, 3, {"'mine'", "'popluation'", "'population'"}));
  EXPECT_THAT(Fault("method: thesis, population: many"), Reports(kSettingUnreadable, 3, {"'population'", "'many'"}));
  EXPECT_THAT(Fault("method: thesis, base: middle"), Reports(kSettingNotOneOf, 3, {"'base'", "random, best"}));
  EXPECT_THAT(Fault("method: thesis, population: 3"),
              Reports(kSettingOutOfRange, 3, {"'mine'", "population = 3", "4"}));
  EXPECT_THAT(Fault("method: thesis, factor: nan"), Reports(kSettingUnreadable, 3, {"'factor'", "'nan'"}));
  EXPECT_THAT(Fault("method: theses"), Reports(kMethodPresetUnknown, 3, {"'theses'", "'thesis'"}));
  EXPECT_THAT(Fault("population: 30"), Reports(kKeyMissing, 3, {"'method'"}));
  EXPECT_THAT(Fault("method: de", {"mine", "mine"}), ReportsOption(kMethodTwice, "--methods", {"'mine'"}));
  EXPECT_THAT(Fault("method: de", {"mien"}), ReportsOption(kMethodUnknown, "--methods", {"'mien'", "'mine'"}));
}

}  // namespace
}  // namespace fourpost::study_methods_test
