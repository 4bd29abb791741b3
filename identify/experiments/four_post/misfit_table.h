#pragma once

#include <string>
#include <vector>

#include "identify/experiments/four_post/response_misfit.h"

namespace fourpost {

/// Misfit of each channel, and of all together; then of each recording, where there are several. What `above` explains
/// is not explained again.
std::string MisfitTable(const std::vector<ChannelMisfit>& misfits, const std::vector<ChannelMisfit>& recordings,
                        const std::string& above = "");

}  // namespace fourpost
