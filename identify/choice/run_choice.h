#pragma once

#include <filesystem>

#include "analysis/process/work_hooks.h"
#include "identify/choice/choice_answer.h"

namespace fourpost {

struct RunChoiceRequest {
  /// The folder of a fit, or a vehicle file, which has no doubt.
  std::filesystem::path run;
  std::filesystem::path settings;
  /// 0: one per processor.
  int threads = 0;
  /// Compare the shortlist with time histories and the multibody system.
  bool has_checks = true;
};

/// Rates the settings of a run's vehicle in cars drawn from its intervals, and chooses one. Throws FaultyInput for a
/// run or settings that cannot be used.
ChoiceAnswer ChooseForRun(const RunChoiceRequest& request, const WorkHooks& hooks);

}  // namespace fourpost
