#include "identify/study_file/channel_source_reader.h"

#include "analysis/files/recorded_unit.h"
#include "analysis/text/number.h"
#include "identify/study_file/findings.h"
#include "identify/study_file/named_channels.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {
namespace {

std::vector<std::string_view> KeysOf(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::kHistory:
      return {"channel", "sign", "scale", "unit", "delay", "offset", "trend", "high_pass", "integrate"};
    case ChannelKind::kCurve: return {"channel", "sign", "scale", "unit"};
    case ChannelKind::kLoad: break;
  }
  return {"channel", "sign", "scale"};
}

/// A point of a curve is one measurement.
bool Combines(ChannelKind kind) { return kind != ChannelKind::kCurve; }

/// Of a high-pass.
constexpr double kLowest_Hz = 1e-6;

double ReadFactor(const StrictMap& map, const std::string& what) {
  const double sign = ParseNumber(map.Text("sign").value_or("1")).value_or(0);
  if (sign != 1 && sign != -1) map.Fault(map.Get("sign"), kChannelSign, {what});
  const double scale = map.Number("scale", 0, 1e12).value_or(1);
  if (scale == 0) map.Fault(map.Get("scale"), kChannelScale, {what});
  return sign * scale;
}

std::string ReadUnit(const StrictMap& map, const std::string& what) {
  const std::string unit = map.Text("unit").value_or("");
  if (!unit.empty() && !ParseRecordedUnit(unit))
    map.Fault(map.Get("unit"), kChannelSourceUnit, {what, unit, RecordedUnitHint(unit)});
  return unit;
}

bool IsCombination(const YAML::Node& node) {
  return node.IsMap() && !node["channel"].IsDefined() && (node["mean"].IsDefined() || node["sum"].IsDefined());
}

/// `node`: several channels. Its sign and scale are those of each of them.
YAML::Node ListOf(const YAML::Node& node, const std::string& name, const std::string& file, double& factor,
                  Diagnostics& diagnostics) {
  const std::string what = "'" + name + "'";
  const StrictMap map(node, what, {"mean", "sum", "sign", "scale"}, file, diagnostics);
  if (map.Has("mean") && map.Has("sum")) map.Fault(node, kChannelMeanAndSum, {what});
  factor = ReadFactor(map, what);
  return map.Has("sum") ? map.Get("sum") : map.Get("mean");
}

ChannelSource ReadSource(const YAML::Node& node, const std::string& name, ChannelKind kind, const std::string& file,
                         Diagnostics& diagnostics) {
  ChannelSource source;
  source.line = LineOf(node);
  if (!IsCombination(node) || !Combines(kind)) {
    source.channels.push_back(ReadSourceChannel(node, "'" + name + "'", kind, file, diagnostics));
    return source;
  }
  if (node["sum"].IsDefined()) source.combine = ChannelSource::Combine::kSum;
  double factor = 1;
  const YAML::Node list = ListOf(node, name, file, factor, diagnostics);
  if (list.IsSequence())
    for (const YAML::Node& entry : list)
      source.channels.push_back(ReadSourceChannel(entry, "'" + name + "'", kind, file, diagnostics));
  for (SourceChannel& channel : source.channels) channel.factor *= factor;
  if (source.channels.empty()) diagnostics.Report(kChannelListEmpty, {file, LineOf(list)}, {"'" + name + "'"});
  return source;
}

/// Reports unknown keys of what names no channel, perhaps for a slip.
bool HasUnknownKeys(const YAML::Node& node, const std::string& what, ChannelKind kind, const std::string& file,
                    Diagnostics& diagnostics) {
  if (!node.IsMap()) return false;
  std::vector<std::string_view> keys = KeysOf(kind);
  if (Combines(kind)) keys.insert(keys.end(), {"mean", "sum"});
  const std::size_t before = diagnostics.items().size();
  const StrictMap map(node, what, keys, file, diagnostics);
  return diagnostics.items().size() > before;
}

}  // namespace

SourceChannel ReadSourceChannel(const YAML::Node& node, const std::string& what, ChannelKind kind,
                                const std::string& file, Diagnostics& diagnostics) {
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  if (!node.IsMap() || !node["channel"].IsDefined()) {
    if (!HasUnknownKeys(node, what, kind, file, diagnostics))
      diagnostics.Report(kChannelNotNamed, {file, LineOf(node)}, {what});
    return {};
  }
  const StrictMap map(node, what, KeysOf(kind), file, diagnostics);
  SourceChannel channel = map.Text("channel").value_or("");
  channel.unit = ReadUnit(map, what);
  channel.factor = ReadFactor(map, what);
  channel.delay_s = map.Quantity("delay", kTime, -1e3).value_or(0);
  channel.offset = map.Text("offset").value_or("");
  if (!channel.offset.empty() && !ParseRecordedQuantity(channel.offset))
    map.Fault(map.Get("offset"), kChannelOffset, {what, channel.offset});
  if (const auto trend = map.Text("trend")) {
    channel.has_trend = *trend == "remove";
    if (!channel.has_trend) map.Fault(map.Get("trend"), kChannelTrend, {what});
  }
  channel.high_pass_Hz = map.Quantity("high_pass", kFrequency, kLowest_Hz);
  channel.integrated_above_Hz = map.Quantity("integrate", kFrequency, kLowest_Hz);
  return channel;
}

std::vector<std::pair<std::string, ChannelSource>> ReadChannelSources(const YAML::Node& node, const std::string& where,
                                                                      const std::string& what, ChannelKind kind,
                                                                      const std::string& file,
                                                                      Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, ChannelSource>> sources;
  if (!node.IsDefined()) return sources;
  if (!node.IsMap() || node.size() == 0) {
    diagnostics.Report(kChannelsNotMapped, {file, LineOf(node)}, {where, what});
    return sources;
  }
  std::vector<std::string> names;
  for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
  const StrictMap unique(node, where, {names.begin(), names.end()}, file, diagnostics);
  for (const auto& entry : node) {
    const auto name = entry.first.as<std::string>();
    if (IsOthersByName(name, entry.second)) continue;
    sources.emplace_back(name, ReadSource(entry.second, name, kind, file, diagnostics));
  }
  return sources;
}

}  // namespace fourpost
