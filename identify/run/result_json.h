#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "identify/fit/fit.h"
#include "identify/run/fit_verdict.h"
#include "identify/study/loaded_study.h"

namespace fourpost {

/// What was found of a fit.
struct FitFindings {
  FitVerdict verdict = {};
  /// See ConclusionsOf().
  Diagnostics conclusions = {};
  /// About its inputs and its results.
  Diagnostics warnings = {};
};

/// The outcome of a fit as JSON text; numbers in SI. A deviation is null where a parameter has none, its `state` says
/// why; `identifiability` is with all deviations when the fit ended before they could be computed. A parameter has a
/// `prior` when its vehicle file gives it one. `seed`: that of the search; `of_experiments`: keys that they add.
std::string ResultJson(const LoadedStudy& study, std::uint64_t seed, const FitResult& fit,
                       const nlohmann::ordered_json& of_experiments, const FitFindings& found);

}  // namespace fourpost
