#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "identify/channel_source.h"

namespace fourpost {

/// Leaves out the sensors that a recording, which has channels of these names, does not tell of, and says so on stderr.
/// Throws FaultyInput where none is left.
void KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
                  std::vector<std::pair<std::string, ChannelSource>>& channels);

}  // namespace fourpost
