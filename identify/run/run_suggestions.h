#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/suggest/suggestions.h"

namespace fourpost {

struct SuggestRequest {
  /// The folder of a fit.
  std::filesystem::path run;
  /// The study that it fitted.
  std::filesystem::path study;
  /// Values of parameters that it was given, see FitRequest.
  std::vector<std::string> set = {};
  /// 0: one per processor.
  int threads = 0;
};

/// A run's study as the fit ended, and what could be added.
struct RunSuggestions {
  LoadedStudy study;
  /// Of the free parameters, SI.
  Eigen::VectorXd values;
  /// As the fit states it; NaN where it does not.
  double misfit = 0;
  Suggestions suggestions;
};

/// Throws FaultyInput for a run or a study that cannot be used.
RunSuggestions SuggestForRun(const SuggestRequest& request, const WorkHooks& hooks);

/// Writes vehicle.urdf and study.yaml with suggestion number `k`, from 1, into a folder; throws FaultyInput and
/// OutputError.
void WriteApplied(const RunSuggestions& suggestions, std::size_t k, const std::filesystem::path& folder);

}  // namespace fourpost
