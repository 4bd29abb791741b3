#include "identify/study_file/study_about.h"

#include <optional>

#include "identify/study_file/study_yaml.h"

namespace fourpost {

StudyAbout ReadStudyAbout(const StrictMap& study) {
  if (!study.Has("about")) return {};
  const StrictMap about = study.Map("about", {"car", "rig", "date", "operator"});
  const auto text = [&](const char* key) { return about.Text(key).value_or(""); };
  return {.car = text("car"), .rig = text("rig"), .date = text("date"), .operated_by = text("operator")};
}

StudyAbout StudyAboutOf(const std::string& study_text) {
  Diagnostics ignored;
  const std::optional<YAML::Node> root = ReadYaml(study_text, "", ignored);
  if (!root || !root->IsMap()) return {};
  return ReadStudyAbout(StrictMap(*root, "study", {"about"}, "", ignored));
}

}  // namespace fourpost
