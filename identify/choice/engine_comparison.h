#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "analysis/process/work_hooks.h"
#include "identify/choice/choice.h"

namespace fourpost {

/// What rounds of comparisons with time histories have in common.
struct ComparedSettings {
  /// Rows of the choice that were computed over time, with an answer or without.
  std::set<std::size_t> tried;
  /// Of the present setting, once it was computed.
  std::optional<SettingScore> present;
};

/// Compares the changes of the best settings against the present one with those of time histories, where they are not
/// among those `compared`. Returns whether one has an answer, or whether it was interrupted. `choice` has a
/// best one.
bool CompareHistories(const ChoiceRequest& request, ComparedSettings& compared, const WorkHooks& hooks, Choice& choice,
                      Diagnostics& findings);

/// The same of the best one by the multibody system, and findings where engines disagree, or prefer another setting.
void CompareFull(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice);

}  // namespace fourpost
