#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/print.h"
#include "identify/study/experiment_kinds.h"
#include "identify/study/study_audit.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// A file that was read, and what it holds.
struct Described {
  std::string file;
  RecordingLook look;
};

/// That of the last kind of experiment which takes the table: later ones are more special. Null where none does.
const RecordingViewer* ViewerOf(const RecordedTable& table) {
  const RecordingViewer* viewer = nullptr;
  for (const ExperimentKind& kind : ExperimentKinds())
    if (kind.recordings->takes(table)) viewer = kind.recordings;
  return viewer;
}

/// A study: what its channels say of each other.
std::optional<Described> DescribeStudy(const std::filesystem::path& file, Diagnostics& faults) {
  const std::optional<LoadedStudy> study = LoadStudy(file, faults);
  if (!study) return std::nullopt;
  Diagnostics findings;
  const std::optional<Audit> audit = CheckRecordings(*study, Severity::kWarning, findings);
  Json files = Json::array();
  for (const std::filesystem::path& input : study->InputFiles()) files.push_back(input.string());
  Json json = {{"kind", "study"},
               {"inputs", std::move(files)},
               {"audit", audit ? AuditJson(*audit) : Json()},
               {"warnings", WarningsJson(findings)}};
  std::string text =
      audit ? AuditText(*audit) : "no audit: it needs stepped sines, and posts and wheelpans as stated\n";
  for (const Diagnostic& finding : findings.ByWeight()) text += Format(finding) + '\n';
  return Described{file.string(), {std::move(text), std::move(json)}};
}

std::optional<Described> Describe(const std::filesystem::path& file, Diagnostics& faults) {
  if (IsStudy(file)) return DescribeStudy(file, faults);
  if (!MayBeRecording(file, faults)) return std::nullopt;
  try {
    const std::optional<RecordedTable> table = ReadRecordedTable(file, faults);
    const RecordingViewer* viewer = table ? ViewerOf(*table) : nullptr;
    if (viewer == nullptr) return std::nullopt;
    std::optional<RecordingLook> look = viewer->look(file, *table, faults);
    if (!look) return std::nullopt;
    return Described{file.string(), *std::move(look)};
  } catch (const FaultyInput& faulty) {
    faults.Add(faulty.diagnostics());
    return std::nullopt;
  }
}

std::string AllText(const std::vector<Described>& files) {
  std::string text;
  for (const Described& file : files) text += (text.empty() ? "" : "\n") + file.file + ": " + file.look.text;
  return text;
}

std::string AllJson(const std::vector<Described>& files) {
  Json list = Json::array();
  for (const Described& file : files) {
    Json json = {{"file", file.file}};
    json.update(file.look.json);
    list.push_back(std::move(json));
  }
  return JsonText(Json{{"files", list}});
}

}  // namespace

int Run(const InfoCommand& command) {
  Diagnostics faults;
  std::vector<Described> files;
  for (const std::filesystem::path& file : command.files)
    if (std::optional<Described> described = Describe(file, faults)) files.push_back(*std::move(described));
  if (!files.empty() && command.json) Print(AllJson(files));
  else if (!files.empty()) PrintText(AllText(files));
  if (faults.HasErrors()) throw FaultyInput(faults);
  Tell(faults);
  return kGood;
}

}  // namespace fourpost
