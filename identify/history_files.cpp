#include "identify/history_files.h"

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/csv_writer.h"
#include "analysis/number.h"
#include "identify/channel_json.h"
#include "identify/versions.h"

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

std::string HistoryJson(const Vehicle& vehicle, const HistoryOrigin& origin, const TimeHistory& history,
                        const std::vector<HistoryChannel>& channels, const Diagnostics& findings) {
  Json parameters = Json::object();
  for (const Parameter& parameter : vehicle.parameters) parameters[parameter.name] = parameter.value;
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  const Json json = {{"vehicle", vehicle.name},
                     {"parameters", parameters},
                     {"motion", origin.motion},
                     {"engine", origin.engine},
                     {"start_s", history.start_s},
                     {"rate_Hz", history.rate_Hz},
                     {"samples", history.size()},
                     {"seed", origin.seed},
                     {"interrupted", origin.interrupted},
                     {"integration",
                      {{"error_asked", origin.error},
                       {"change_by_last_halving", OrNull(origin.change)},
                       {"step_s", OrNull(origin.step_s)}}},
                     {"channels", ChannelsJson(channels)},
                     {"findings", FindingsJson(findings)},
                     {"versions", versions}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fourpost
