#include "identify/channel_source_reader.h"

#include "identify/strict_yaml.h"

namespace fourpost {
namespace {

ChannelSource ReadSource(const YAML::Node& node, const std::string& name, const std::string& file,
                         Diagnostics& diagnostics) {
  ChannelSource source;
  source.line = LineOf(node);
  if (node.IsScalar() && !node.Scalar().empty()) {
    source.channels.push_back(node.Scalar());
    return source;
  }
  if (!node.IsMap() || node.size() != 1) {
    diagnostics.Error(file, LineOf(node), "'" + name + "' must be a measured channel, {mean: [a, b]} or {sum: [a, b]}");
    return source;
  }
  const StrictMap map(node, "'" + name + "'", {"mean", "sum"}, file, diagnostics);
  source.combine = map.Has("sum") ? ChannelSource::Combine::kSum : ChannelSource::Combine::kMean;
  const YAML::Node list = node.begin()->second;
  if (list.IsSequence())
    for (const YAML::Node& entry : list)
      if (entry.IsScalar()) source.channels.push_back(entry.Scalar());
  if (source.channels.empty() || source.channels.size() != list.size())
    diagnostics.Error(file, LineOf(list), "'" + name + "' must be a list of channels");
  return source;
}

}  // namespace

std::vector<std::pair<std::string, ChannelSource>> ReadChannelSources(const YAML::Node& node, const std::string& where,
                                                                      const std::string& what, const std::string& file,
                                                                      Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, ChannelSource>> sources;
  if (!node.IsDefined()) return sources;
  if (!node.IsMap() || node.size() == 0) {
    diagnostics.Error(file, LineOf(node), where + " must map " + what + " of the vehicle to measured channels");
    return sources;
  }
  std::vector<std::string> names;
  for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
  const StrictMap unique(node, where, {names.begin(), names.end()}, file, diagnostics);
  for (const auto& entry : node) {
    const auto name = entry.first.as<std::string>();
    sources.emplace_back(name, ReadSource(entry.second, name, file, diagnostics));
  }
  return sources;
}

}  // namespace fourpost
