#include "identify/report/fitted_data.h"

#include <algorithm>
#include <array>

#include <yaml-cpp/yaml.h>

#include "identify/study_file/result_reader.h"
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

/// Of a study what its residuals depend on beside model and files; the text where it is no YAML.
Json SettingsOf(const std::string& study, ExperimentReports experiments) {
  constexpr std::array<const char*, 7> kOfNoExperiment = {"vehicle", "about",  "free",   "search",
                                                          "refine",  "target", "methods"};
  Diagnostics faults;
  const std::optional<YAML::Node> root = ReadYaml(study, "study.yaml", faults);
  if (!root) return study;
  Json settings = JsonOf(*root);
  EraseKeys(settings, kOfNoExperiment);
  if (settings.is_object())
    for (const ExperimentReport* experiment : experiments) experiment->EraseUnseen(settings);
  return settings;
}

}  // namespace

std::vector<std::string> FittedDigests(const Json& result) {
  std::vector<std::string> digests;
  for (const Json& file : ListAt(result, "fitted_files")) digests.push_back(TextAt(file, "sha256"));
  std::sort(digests.begin(), digests.end());
  return digests;
}

Json FittedData(const RunFolder& run, ExperimentReports experiments) {
  const Json& result = run.result;
  Json channels = Json::array();
  for (const Json& channel : ListAt(result, "channels"))
    channels.push_back({TextAt(channel, "recording"), TextAt(channel, "name")});
  std::sort(channels.begin(), channels.end());
  const Json refine = result.value("refine", Json::object());
  const std::string* study = run.Find("study.yaml");
  Json data = {FittedRecordings(result),
               channels,
               FittedDigests(result),
               study == nullptr ? Json() : SettingsOf(*study, experiments),
               result.value("residuals", Json()),
               TextAt(refine, "loss"),
               refine.value("scale", Json())};
  for (const ExperimentReport* experiment : experiments) data.push_back(experiment->FittedData(result));
  return data;
}

}  // namespace fourpost
