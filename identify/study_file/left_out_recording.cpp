#include "identify/study_file/left_out_recording.h"

#include "identify/study_file/findings.h"

namespace fourpost {

std::optional<LeftOutRecording> LeftOutFor(const Diagnostics& found, const std::string& name,
                                           const std::filesystem::path& file, Diagnostics& diagnostics) {
  LeftOutRecording left_out{.name = name, .file = file, .reason = {}};
  for (Diagnostic finding : found.items()) {
    if (finding.severity == Severity::kError) {
      if (left_out.reason.empty()) diagnostics.Report(kValidationLeftOut, finding.place, {name});
      left_out.reason += (left_out.reason.empty() ? "" : "; ") + finding.message;
    }
    finding.severity = Severity::kWarning;
    diagnostics.Add(std::move(finding));
  }
  return left_out.reason.empty() ? std::nullopt : std::optional(left_out);
}

}  // namespace fourpost
