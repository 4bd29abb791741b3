#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "identify/study_file/channel_source.h"

namespace fourpost {

/// Leaves out the sensors that a recording, which has channels of these names, does not tell of. Their names, joined by
/// commas. Throws FaultyInput where none is left.
std::string KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
                         std::vector<std::pair<std::string, ChannelSource>>& channels);

}  // namespace fourpost
