#pragma once

#include <string>
#include <vector>

#include "identify/run/fit_run.h"

namespace fourpost {

/// A step of a fit that adds to its vehicle what lowers BIC.
struct GrowthStep {
  /// "dry friction beside damper 'front'"; empty: the study as it stands.
  std::string added;
  std::string mechanism;
  std::vector<std::string> elements;
  /// Below the output: where the step's study and its fit are.
  std::string folder;
  double cost = 0;
  double misfit = 0;
  /// See CriterionChange(), against the step before; 0 of the first.
  double criterion = 0;
  /// Root mean square over the channels of all validation recordings of what is left of them, in per cent; NaN without
  /// such recordings.
  double validation_percent = 0;
  bool is_kept = false;
  /// Why it is not.
  std::string reason = {};
};

struct GrownFit {
  std::vector<GrowthStep> steps;
  /// Of the last step that was kept, and its folder: the output itself, but for a first fit that was interrupted.
  FitRun fit;
  std::filesystem::path folder;
  /// Why it added no more: "nothing more pays".
  std::string end = {};
  /// Stopped before it was known whether more pays.
  bool is_interrupted = false;
};

/// Fits the study, asks what could be added, adds the best of it, fits again, and goes on while the extended BIC falls
/// and validation recordings are predicted no worse, until the stated errors explain the residuals. Writes each step
/// into `steps/N` of the output, growth.json, and the last fit that was kept into the output itself. A step that cannot
/// be made ends it with those before. Throws as FitStudy() does for the first.
GrownFit GrowFit(const FitRequest& request, const FitRunHooks& hooks = {});

}  // namespace fourpost
