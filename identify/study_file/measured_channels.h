#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

/// Leaves out the sensors that a recording, which has channels of these names, has not measured, with a warning. Throws
/// FaultyInput where none is left.
void KeepMeasured(const std::filesystem::path& recording, const std::vector<std::string>& names,
                  std::vector<std::pair<std::string, ChannelSource>>& channels, Diagnostics& diagnostics);

}  // namespace fourpost
