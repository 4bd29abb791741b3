#pragma once

#include <string>

#include "identify/study_file/channel_source.h"

namespace fourpost {

/// As a study writes it: "a", "{channel: a, unit: g, sign: -1, scale: 2, delay: 20 ms}",
/// "{mean: [a, {channel: b, sign: -1}]}"; numbers at five digits.
std::string SourceText(const ChannelSource& source);

}  // namespace fourpost
