#pragma once

#include <filesystem>

#include "identify/run/fit_run.h"
#include "identify/run/growth_path.h"

namespace fourpost {

struct GrownFit {
  GrowthPath path;
  /// Of the last step that was kept, and its folder: the output itself, but for a first fit that was interrupted.
  FitRun fit;
  std::filesystem::path folder;
  /// Stopped before it was known whether more pays.
  bool is_interrupted = false;
};

/// Fits the study, asks what could be added, adds the best of it, fits again, and goes on while the extended BIC falls
/// and validation recordings are predicted no worse, until the stated errors explain the residuals. Writes each step
/// into `steps/N` of the output, growth.json, and the last fit that was kept into the output itself. An addition that
/// cannot be fitted is refused. The same request goes on where one of before was interrupted: neither what was kept nor
/// what was refused is fitted again. Throws as FitStudy() does for the first.
GrownFit GrowFit(const FitRequest& request, const FitRunHooks& hooks = {});

}  // namespace fourpost
