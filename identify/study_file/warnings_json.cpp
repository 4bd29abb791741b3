#include "identify/study_file/warnings_json.h"

#include <filesystem>
#include <string>

namespace fourpost {

nlohmann::ordered_json WarningsJson(const Diagnostics& diagnostics) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnostic& item : diagnostics.ByWeight()) {
    if (item.severity != Severity::kWarning) continue;
    std::string place = std::filesystem::path(Name(item.place)).filename().string();
    if (item.place.line > 0) place += ":" + std::to_string(item.place.line);
    list.push_back({{"id", item.id}, {"text", (place.empty() ? "" : place + ": ") + item.message}});
  }
  return list;
}

}  // namespace fourpost
