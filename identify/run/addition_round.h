#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/process/work_hooks.h"
#include "identify/run/growth_path.h"
#include "identify/suggest/suggestions.h"

namespace fourpost {

/// Places of the suggestions that lower the criterion, but for what was taken back, which would come again: those that
/// explain the residuals together come first, what is worth most beside the others before the rest. Alone an addition
/// may be worth most because it imitates several others. At most four, and two of a mechanism.
std::vector<std::size_t> WorthTrying(const Suggestions& suggestions, const GrowthRound& round,
                                     const std::vector<std::string>& taken_back);

/// What is to be added to the last step that was kept, see WorthTrying(), their studies in folders. With validation
/// recordings the criterion takes the size of the residuals in place of the stated errors. Nothing where the user stops
/// it.
std::optional<GrowthRound> FindAdditions(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks);

}  // namespace fourpost
