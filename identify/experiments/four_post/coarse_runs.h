#pragma once

#include <optional>
#include <vector>

#include "identify/experiments/four_post/four_post_data.h"

namespace fourpost {

/// The runs at every fourth frequency, where they have many: they lead refinements at a quarter of the cost. Nothing
/// where no run has frequencies to spare.
std::optional<std::vector<MeasuredRun>> CoarseRuns(const std::vector<MeasuredRun>& runs);

}  // namespace fourpost
