#pragma once

#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "analysis/diagnostics.h"
#include "identify/channel_source.h"

namespace fourpost {

/// A map from names of the vehicle to what was measured for them: a channel, {mean: [a, b]} or {sum: [a, b]}. `what`:
/// the kind of names, such as "sensors". Adds every fault to `diagnostics`.
std::vector<std::pair<std::string, ChannelSource>> ReadChannelSources(const YAML::Node& node, const std::string& where,
                                                                      const std::string& what, const std::string& file,
                                                                      Diagnostics& diagnostics);

}  // namespace fourpost
