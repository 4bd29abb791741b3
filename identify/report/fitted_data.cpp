#include "identify/report/fitted_data.h"

#include <algorithm>
#include <initializer_list>
#include <set>

#include <yaml-cpp/yaml.h>

#include "identify/report/run_result.h"
#include "identify/study_file/study_yaml.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

/// Scalars as they are written.
Json JsonOf(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  Json json;
  if (node.IsMap())
    for (const auto& entry : node) json[entry.first.Scalar()] = JsonOf(entry.second);
  if (node.IsSequence())
    for (const YAML::Node& entry : node) json.push_back(JsonOf(entry));
  return json;
}

void Erase(Json& object, std::initializer_list<const char*> keys) {
  if (!object.is_object()) return;
  for (const char* key : keys) object.erase(key);
}

/// Without what the fit does not see. Files are compared by their bytes, wherever they lie.
Json FittedOf(const Json& recordings) {
  Json fitted = Json::array();
  for (Json recording : recordings) {
    if (recording.is_object() && recording.value("use", Json()) == "validation") continue;
    Erase(recording, {"file", "use"});
    fitted.push_back(std::move(recording));
  }
  return fitted;
}

/// Of a study what its residuals depend on beside model and files; the text where it is no YAML.
Json SettingsOf(const std::string& study) {
  Diagnostics faults;
  const std::optional<YAML::Node> root = ReadYaml(study, "study.yaml", faults);
  if (!root) return study;
  Json settings = JsonOf(*root);
  Erase(settings, {"vehicle", "free", "search", "refine", "target", "methods"});
  if (!settings.is_object()) return settings;
  for (const char* list : {"recordings", "histories"})
    if (settings.contains(list)) settings[list] = FittedOf(settings[list]);
  if (settings.value("histories", Json()) == Json::array()) settings.erase("histories");
  if (settings.contains("static_loads")) Erase(settings["static_loads"], {"file"});
  if (settings.contains("bench")) Erase(settings["bench"], {"damper", "recordings", "validation"});
  return settings;
}

Json StaticLoads(const Json& result) {
  Json loads = Json::array();
  for (const Json& load : ListAt(result, "static_loads"))
    loads.push_back({TextAt(load, "tyre"), load.value("measured_N", Json()), load.value("sd_N", Json())});
  return loads;
}

}  // namespace

std::vector<std::string> FittedDigests(const Json& result) {
  std::vector<std::string> digests;
  for (const Json& file : ListAt(result, "fitted_files")) digests.push_back(TextAt(file, "sha256"));
  std::sort(digests.begin(), digests.end());
  return digests;
}

std::vector<std::string> FittedRecordings(const Json& result) {
  std::set<std::string> names;
  for (const char* list : {"recordings", "channels"})
    for (const Json& entry : ListAt(result, list))
      names.insert(TextAt(entry, std::string(list) == "channels" ? "recording" : "name"));
  names.erase("");
  return {names.begin(), names.end()};
}

Json FittedData(const Json& result, const RunContents& run) {
  Json channels = Json::array();
  for (const Json& channel : ListAt(result, "channels"))
    channels.push_back({TextAt(channel, "recording"), TextAt(channel, "name")});
  std::sort(channels.begin(), channels.end());
  const Json refine = result.value("refine", Json::object());
  // Fits of time histories alone once stated a band from 0 to 0 Hz.
  const Json band = ListAt(result, "recordings").empty() ? Json() : result.value("band_Hz", Json());
  const auto study = run.files.find("study.yaml");
  return {FittedRecordings(result),
          channels,
          FittedDigests(result),
          StaticLoads(result),
          study == run.files.end() ? Json() : SettingsOf(study->second),
          result.value("residuals", Json()),
          band,
          TextAt(refine, "loss"),
          refine.value("scale", Json()),
          TextAt(result, "history_cost")};
}

}  // namespace fourpost
