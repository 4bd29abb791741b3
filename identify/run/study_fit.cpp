#include "identify/run/study_fit.h"

#include "identify/study/study_methods.h"

namespace fourpost {

FitOptions FitOptionsOf(const Study& study, const VehicleObjective& objective) {
  const StudySearch& search = study.search;
  FitOptions options;
  Diagnostics diagnostics;
  options.search = ExplorationOf(study, objective.MakeProblem(), diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  options.seed = search.seed;
  options.stop.max_evaluations = search.evaluations.value_or(100);
  options.stop.max_generations = search.generations;
  options.stop.max_stagnant_generations = search.stagnation;
  options.stop.max_seconds = search.time_s;
  options.candidates.count = search.starts;
  options.starts = search.starts;
  options.identify_first = true;
  options.deadline_s = search.deadline_s;
  options.refine.differences = Differences::kAutomatic;
  const LossKind loss = study.refine.loss;
  options.refine.loss = RobustLoss(loss, study.refine.scale.value_or(UsualScale(loss)), objective.prior_count());
  return options;
}

}  // namespace fourpost
