#pragma once

#include "analysis/process/work_hooks.h"
#include "identify/choice/choice.h"

namespace fourpost {

/// Compares the changes of the best settings against the present one with those of time histories, where `choice` has
/// no checks of them yet. Returns whether it made one. `choice` has a best one.
bool CompareHistories(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice);

/// The same of the best one by the multibody system, and findings where engines disagree, or prefer another setting.
void CompareFull(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice);

}  // namespace fourpost
