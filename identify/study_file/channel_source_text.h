#pragma once

#include <string>

#include "identify/study_file/channel_source.h"

namespace fourpost {

/// A name as YAML has it: in quotes where it would be read as something else.
std::string YamlText(const std::string& name);

/// As a study writes it: "a", "{channel: a, unit: g, sign: -1, scale: 2, delay: 20 ms}",
/// "{mean: [a, {channel: b, sign: -1}]}"; numbers at five digits.
std::string SourceText(const ChannelSource& source);

}  // namespace fourpost
