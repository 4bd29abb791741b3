#include "vehicles/tags/file_faults.h"

#include <algorithm>

#include "vehicles/tags/attribute_check.h"

namespace fourpost {

void FileFaults::Report(const Finding& finding, int line, const std::vector<std::string>& words) {
  if (finding.severity() == Severity::kError) ++errors_;
  if (!IsReported(line, finding.Message(words))) diagnostics_.Report(finding, {file_, line}, words);
}

bool FileFaults::IsReported(int line, const std::string& message) {
  if (twins_.empty()) return false;
  std::string written = AsWritten(message);
  const bool is_of_twin = written != message;
  const bool is_new = reported_.emplace(line, std::move(written)).second;
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
