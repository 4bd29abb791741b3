#pragma once

#include <optional>

#include "analysis/process/work_hooks.h"
#include "identify/run/growth_path.h"

namespace fourpost {

/// Change of the criterion, see CriterionChange(), where what lowers the cost from `cost_without` to that of a step is
/// taken back: below 0 where the criterion would not have it. Counts and residuals are those of the step.
double TakeBackChange(const GrowthStep& with, double cost_without, const GrowthAddition& addition);

/// What can be taken back of the additions that stand: those without which the criterion falls, or nearly so, where the
/// other parameters follow by a few steps of the refinement; the best first, at most three, their studies in folders.
/// The newest addition is left out, for it was judged against the fit before it. Nothing where the user stops it.
std::optional<GrowthRound> FindTakeBacks(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks);

}  // namespace fourpost
