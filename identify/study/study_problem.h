#pragma once

#include <optional>

#include "identify/residuals/vehicle_objective.h"
#include "identify/search/evaluation.h"
#include "identify/search/evaluation_store.h"
#include "identify/study/study.h"

namespace fourpost {

/// What a study asks to solve: the fit of a vehicle, or a test problem.
struct StudyProblem {
  std::optional<VehicleObjective> objective;
  /// Refers to `objective`.
  std::optional<Problem> problem;
  /// A cost at which it counts as solved, where one is known.
  std::optional<double> target_cost;
  /// For archives.
  EvaluationContext context;
  /// Warnings.
  Diagnostics findings;
};

/// In place, since the problem of a vehicle refers to its objective. Throws FaultyInput.
void LoadProblem(const Study& study, StudyProblem& out);

/// Throws FaultyInput.
Study ReadStudyOrThrow(const std::filesystem::path& file);

}  // namespace fourpost
