#include "identify/study_file/control_reader.h"

#include <algorithm>

#include "analysis/text/number.h"
#include "identify/study_file/findings.h"

namespace fourpost {

StudyControl ReadStudyControl(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics) {
  StudyControl control;
  if (!node.IsMap() || node.size() == 0) {
    diagnostics.Report(kControlNotMapped, {file, LineOf(node)});
    return control;
  }
  std::vector<std::string> names;
  for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
  const StrictMap map(node, "'control'", {names.begin(), names.end()}, file, diagnostics);
  for (const std::string& name : names) {
    const std::string how = node[name].IsScalar() ? node[name].Scalar() : "";
    if (how != "linear" && how != "per setting") map.Fault(node[name], kControlUnknown, {name});
    control.followers.push_back({.parameter = name, .is_linear = how == "linear", .line = LineOf(node[name])});
  }
  return control;
}

std::optional<double> ReadSetting(const StrictMap& recording) {
  const std::optional<std::string> text = recording.Text("control");
  if (!text) return std::nullopt;
  const std::size_t end = std::min(text->find_first_not_of("+-.0123456789eE"), text->size());
  const std::optional<double> number = ParseNumber(text->substr(0, end));
  if (!number) recording.Fault(recording.Get("control"), kSettingNoNumber, {*text});
  return number;
}

}  // namespace fourpost
