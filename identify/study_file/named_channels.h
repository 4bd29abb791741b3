#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "analysis/files/recorded_table.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

// Channels that are called as what they were measured for, and so need no line in a study.

/// Whether `channels` of a study leaves what it does not name to the names of channels: where it is missing, or has the
/// entry `others: by name`.
bool TakesOthersByName(const YAML::Node& channels);
/// Whether this is that entry.
bool IsOthersByName(const std::string& name, const YAML::Node& value);

/// Of a stepped sine the channels that its rows are of, of other recordings the columns.
std::vector<std::string> ChannelNames(const RecordedTable& table);

/// Adds to `sources` each name that is recorded and not there yet, in its order. `line`: of the study.
void AddByName(std::span<const std::string> names, std::span<const std::string> recorded, int line,
               std::vector<std::pair<std::string, ChannelSource>>& sources);

}  // namespace fourpost
