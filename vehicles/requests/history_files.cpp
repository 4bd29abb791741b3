#include "vehicles/requests/history_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include <nlohmann/json.hpp>

#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/files/rpc/rpc_writer.h"
#include "analysis/files/universal/universal_writer.h"
#include "analysis/text/number.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

double EightDigits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", value);
  return ParseNumber(text).value_or(value);
}

Json OrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json ChannelsJson(const std::vector<HistoryChannel>& channels) {
  Json list = Json::array();
  for (const HistoryChannel& channel : channels) {
    const Extent extent = ExtentOf(channel.values);
    list.push_back({{"name", channel.name},
                    {"unit", channel.unit},
                    {"mean", extent.mean},
                    {"rms", extent.rms},
                    {"peak", extent.peak},
                    {"peak_to_peak", extent.peak_to_peak}});
  }
  return list;
}

Recording AsRecording(const std::string& motion, const TimeHistory& history,
                      const std::vector<HistoryChannel>& channels) {
  Recording recording{.format = "", .description = motion};
  for (const HistoryChannel& channel : channels)
    recording.channels.push_back({.name = channel.name,
                                  .unit = channel.unit,
                                  .start_s = std::round(1e9 * history.start_s) / 1e9,
                                  .step_s = 1 / history.rate_Hz,
                                  .values = {channel.values.begin(), channel.values.end()}});
  return recording;
}

}  // namespace

std::string HistoryCsv(const TimeHistory& history, const std::vector<HistoryChannel>& channels) {
  std::vector<std::string> names = {"time"};
  for (const HistoryChannel& channel : channels) names.push_back(channel.name);
  CsvWriter csv(names);
  csv.Add("s");
  for (const HistoryChannel& channel : channels) csv.Add(channel.unit);
  for (Eigen::Index k = 0; k < history.size(); ++k) {
    csv.Add(std::round(1e9 * history.TimeAt(k)) / 1e9);
    for (const HistoryChannel& channel : channels) csv.Add(EightDigits(channel.values[k]));
  }
  return csv.text();
}

std::string HistoryUniversal(const std::string& motion, const TimeHistory& history,
                             const std::vector<HistoryChannel>& channels) {
  return UniversalBytes(AsRecording(motion, history, channels));
}

std::string HistoryRpc(const std::string& motion, const TimeHistory& history,
                       const std::vector<HistoryChannel>& channels) {
  return RpcBytes(AsRecording(motion, history, channels), RpcNumbers::kFloat);
}

std::string HistoryDrive(const std::string& motion, const TimeHistory& history,
                         const std::vector<HistoryChannel>& channels) {
  std::vector<HistoryChannel> posts;
  std::copy_if(channels.begin(), channels.end(), std::back_inserter(posts),
               [](const HistoryChannel& channel) { return channel.name.starts_with("post_"); });
  return RpcBytes(AsRecording(motion, history, posts), RpcNumbers::kShortInteger);
}

Json EngineJson(const HistoryEngine& by, double error) {
  Json json = {{"engine", by.correction_change ? "full by correction" : EngineName(by.engine)},
               {"integration",
                {{"error_asked", error}, {"change_by_last_halving", OrNull(by.change)}, {"step_s", OrNull(by.step_s)}}},
               {"linear_kinematics_error", nullptr}};
  if (by.kinematics_error)
    json["linear_kinematics_error"] = {{"value", by.kinematics_error->share},
                                       {"channel", by.kinematics_error->channel},
                                       {"visible", by.kinematics_error->IsVisible()}};
  if (by.correction_change) json["correction_change"] = *by.correction_change;
  if (!by.not_estimated.empty()) json["linear_kinematics_error"] = {{"not_estimated", by.not_estimated}};
  return json;
}

std::string HistoryJson(const Vehicle& vehicle, const HistoryOrigin& origin, const TimeHistory& history,
                        const std::vector<HistoryChannel>& channels, const Diagnostics& findings) {
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json json = {{"vehicle", vehicle.name}, {"parameters", parameters}, {"motion", origin.motion}};
  json.update(EngineJson(origin.by, origin.error));
  json.update({{"start_s", history.start_s},
               {"rate_Hz", history.rate_Hz},
               {"samples", history.size()},
               {"seed", origin.seed},
               {"interrupted", origin.interrupted},
               {"channels", ChannelsJson(channels)},
               {"findings", FindingsJson(findings)},
               {"versions", versions}});
  return JsonText(json);
}

}  // namespace fourpost
