#pragma once

#include "analysis/process/work_hooks.h"
#include "identify/choice/choice.h"

namespace fourpost {

/// Compares the changes of the best settings against the present one with those of the engines that the request names:
/// checks of the choice, and findings where they disagree, or prefer another setting. `choice` has a best one.
void CompareEngines(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice);

}  // namespace fourpost
