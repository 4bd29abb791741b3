#pragma once

#include <string_view>

#include "identify/search/evaluation_store.h"
#include "identify/study/loaded_study.h"

namespace fourpost {

/// What the residuals of a study depend on beside the free parameters' values:
/// - vehicle: its file but for comments and blank space, and the masses that its meshes make;
/// - data: the recordings within the band as the fit sees them, and the static loads;
/// - settings: which parameters are free, the model error and the deadline of an evaluation;
/// - version: this very program and its libraries.
/// Seed, budget and method are not among them: they only choose the values.
EvaluationContext ContextOf(const LoadedStudy& study);

/// The same of a test problem, see kTestProblems.
EvaluationContext ContextOfProblem(std::string_view name, double deadline_s);

}  // namespace fourpost
