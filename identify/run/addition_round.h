#pragma once

#include <optional>

#include "analysis/process/work_hooks.h"
#include "identify/run/growth_path.h"

namespace fourpost {

/// What is to be added to the last step that was kept: what lowers the criterion most, at most four and two of a
/// mechanism, their studies in folders; nothing that was taken back before. With validation recordings the criterion
/// takes the size of the residuals in place of the stated errors. Nothing where the user stops it.
std::optional<GrowthRound> FindAdditions(const GrowthOrigin& origin, const GrowthPath& path, const WorkHooks& hooks);

}  // namespace fourpost
