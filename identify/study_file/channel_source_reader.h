#pragma once

#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "analysis/text/diagnostics.h"
#include "identify/study_file/channel_source.h"

namespace fourpost {

/// What a study may say of a channel: loads have units of their own and no time, points of curves no time either.
enum class ChannelKind { kHistory, kLoad, kCurve };

/// A channel: its name, or {channel: name, unit: mm, sign: -1, scale: 1.02, delay: 2 ms}; `what` names it in messages.
SourceChannel ReadSourceChannel(const YAML::Node& node, const std::string& what, ChannelKind kind,
                                const std::string& file, Diagnostics& diagnostics);

/// A map from names of the vehicle to what was measured for them: a channel, or {mean: [a, b]} or {sum: [a, b]} of
/// some; `others: by name` is left out, see TakesOthersByName(). `what`: the kind of names, such as "sensors". Adds
/// every fault to `diagnostics`.
std::vector<std::pair<std::string, ChannelSource>> ReadChannelSources(const YAML::Node& node, const std::string& where,
                                                                      const std::string& what, ChannelKind kind,
                                                                      const std::string& file,
                                                                      Diagnostics& diagnostics);

}  // namespace fourpost
