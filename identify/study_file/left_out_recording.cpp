#include "identify/study_file/left_out_recording.h"

namespace fourpost {

std::optional<LeftOutRecording> LeftOutFor(const Diagnostics& found, const std::string& name,
                                           const std::filesystem::path& file, Diagnostics& diagnostics) {
  LeftOutRecording left_out{.name = name, .file = file, .reason = {}};
  for (const Diagnostic& finding : found.items()) {
    const bool is_fault = finding.severity == Severity::kError;
    if (is_fault) left_out.reason += (left_out.reason.empty() ? "" : "; ") + finding.message;
    diagnostics.Warning(finding.place.file, finding.place.line,
                        is_fault ? "left out of the validation: " + finding.message : finding.message);
  }
  return left_out.reason.empty() ? std::nullopt : std::optional(left_out);
}

}  // namespace fourpost
