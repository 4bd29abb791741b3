#pragma once

#include <cstddef>
#include <set>

#include "analysis/process/work_hooks.h"
#include "identify/choice/choice.h"

namespace fourpost {

/// Compares the changes of the best settings against the present one with those of time histories, where they are not
/// among the rows that were `tried`. Returns whether one has an answer, or whether it was interrupted. `choice` has a
/// best one.
bool CompareHistories(const ChoiceRequest& request, std::set<std::size_t>& tried, const WorkHooks& hooks,
                      Choice& choice, Diagnostics& findings);

/// The same of the best one by the multibody system, and findings where engines disagree, or prefer another setting.
void CompareFull(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice);

}  // namespace fourpost
