#include "analysis/text/warning_texts.h"

#include <filesystem>

namespace fourpost {

std::vector<std::string> WarningTexts(const Diagnostics& diagnostics) {
  std::vector<std::string> texts;
  for (const Diagnostic& item : diagnostics.items()) {
    if (item.severity != Severity::kWarning) continue;
    std::string place = std::filesystem::path(Name(item.place)).filename().string();
    if (item.place.line > 0) place += ":" + std::to_string(item.place.line);
    texts.push_back((place.empty() ? "" : place + ": ") + item.message);
  }
  return texts;
}

}  // namespace fourpost
