#include "identify/study/study_problem.h"

#include "identify/problems/test_problem.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study_context.h"

namespace fourpost {
namespace {

void LoadModel(const Study& study, StudyProblem& out) {
  if (study.problem) {
    const TestProblem test = MakeTestProblem(*study.problem);
    out.problem = test.problem;
    out.context = ContextOfProblem(*study.problem, study.search.deadline_s);
    out.target_cost = study.target_cost.value_or(test.target_cost);
    return;
  }
  const std::optional<LoadedStudy> loaded = LoadStudy(study.file, out.findings);
  if (!loaded) throw FaultyInput(out.findings);
  out.objective.emplace(loaded->MakeObjective());
  out.problem = out.objective->MakeProblem();
  out.context = ContextOf(*loaded);
  out.target_cost = study.target_cost;
}

}  // namespace

void LoadProblem(const Study& study, StudyProblem& out) {
  LoadModel(study, out);
  out.problem->deadline_s = study.search.deadline_s;
}

Study ReadStudyOrThrow(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  std::optional<Study> study = ReadStudy(file, diagnostics);
  if (!study) throw FaultyInput(diagnostics);
  return *std::move(study);
}

}  // namespace fourpost
