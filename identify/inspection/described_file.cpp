#include "identify/inspection/described_file.h"

#include <algorithm>

#include "identify/inspection/file_kind.h"
#include "identify/inspection/noise_at_rest.h"
#include "identify/study/audit_text.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study_audit.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// That of the last kind of experiment which takes the table: later ones are more special. Null where none does.
const RecordingViewer* ViewerOf(const RecordedTable& table) {
  const RecordingViewer* viewer = nullptr;
  for (const ExperimentKind& kind : ExperimentKinds())
    if (kind.recordings->takes(table)) viewer = kind.recordings;
  return viewer;
}

Json Headed(const std::filesystem::path& file, const Json& content) {
  Json json = {{"file", file.string()}};
  json.update(content);
  return json;
}

std::optional<DescribedFile> DescribeStudy(const std::filesystem::path& file, Diagnostics& faults) {
  const std::optional<LoadedStudy> study = LoadStudy(file, faults);
  if (!study) return std::nullopt;
  DescribedFile described{.file = file.string()};
  const std::optional<Audit> audit = CheckRecordings(*study, Severity::kWarning, described.findings);
  Json files = Json::array();
  for (const std::filesystem::path& input : study->InputFiles()) files.push_back(input.string());
  described.json = Headed(file, {{"kind", "study"},
                                 {"inputs", std::move(files)},
                                 {"audit", audit ? AuditJson(*audit) : Json()},
                                 {"warnings", WarningsJson(described.findings)}});
  described.text = audit ? AuditText(*audit) : NoAuditText(*study, described.findings);
  described.is_refused =
      std::any_of(described.findings.items().begin(), described.findings.items().end(), ContradictsAnAudit);
  described.text += NoiseAtRestText(*study);
  for (const Diagnostic& finding : described.findings.ByWeight()) described.text += Format(finding) + '\n';
  return described;
}

}  // namespace

std::optional<DescribedFile> DescribeFile(const std::filesystem::path& file, Diagnostics& faults) {
  if (IsStudy(file)) return DescribeStudy(file, faults);
  if (!MayBeRecording(file, faults)) return std::nullopt;
  try {
    const std::optional<RecordedTable> table = ReadRecordedTable(file, faults);
    const RecordingViewer* viewer = table ? ViewerOf(*table) : nullptr;
    if (viewer == nullptr) return std::nullopt;
    std::optional<RecordingLook> look = viewer->look(file, *table, faults);
    if (!look) return std::nullopt;
    return DescribedFile{.file = file.string(), .text = std::move(look->text), .json = Headed(file, look->json)};
  } catch (const FaultyInput& faulty) {
    faults.Add(faulty.diagnostics());
    return std::nullopt;
  }
}

}  // namespace fourpost
