#pragma once

#include <string>
#include <vector>

#include "identify/misfit.h"

namespace fourpost {

/// Misfit of each channel, and of all together.
std::string MisfitTable(const std::vector<ChannelMisfit>& misfits);

}  // namespace fourpost
