#include "vehicles/tags/file_faults.h"

#include <algorithm>

#include "vehicles/tags/attribute_check.h"

namespace fourpost {

void FileFaults::Error(int line, std::string message) {
  if (!IsTold(line, message)) diagnostics_.Error(file_, line, std::move(message));
  ++errors_;
}

void FileFaults::Warning(int line, std::string message) {
  if (!IsTold(line, message)) diagnostics_.Warning(file_, line, std::move(message));
}

bool FileFaults::IsTold(int line, const std::string& message) {
  if (twins_.empty()) return false;
  std::string written = AsWritten(message);
  const bool is_of_twin = written != message;
  const bool is_new = told_.emplace(line, std::move(written)).second;
  return is_of_twin && !is_new;
}

std::string FileFaults::AsWritten(const std::string& message) const {
  std::string text;
  for (auto at = message.begin(); at != message.end();) {
    const auto end = std::find_if_not(at, message.end(), IsNameCharacter);
    const auto twin = twins_.find(std::string(at, end));
    text += twin == twins_.end() ? std::string(at, end) : twin->second;
    at = end;
    if (at != message.end()) text += *at++;
  }
  return text;
}

}  // namespace fourpost
