#include "identify/command_line/run_folder.h"

#include <algorithm>
#include <system_error>

#include "analysis/files/near_file.h"
#include "analysis/files/text_file.h"
#include "analysis/text/diagnostics.h"
#include "identify/command_line/findings.h"
#include "identify/report/run_result.h"
#include "identify/study/experiment_kinds.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr const char* kResult = "result.json";

/// What is read as text.
std::vector<std::string> OtherFiles() {
  std::vector<std::string> names = {"study.yaml", "vehicle.urdf"};
  for (const ExperimentReport* experiment : AllExperimentReports())
    for (const std::string& name : experiment->Files()) names.push_back(name);
  return names;
}

/// The first finding, which is what keeps a vehicle from being shown.
std::string Reason(const Diagnostics& findings) {
  return findings.items().empty() ? "vehicle.urdf cannot be read" : findings.items().front().message;
}

void ReadFittedVehicle(const std::filesystem::path& file, RunContents& run) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) {
    run.vehicle_fault = "vehicle.urdf is missing";
    return;
  }
  Diagnostics findings;
  run.vehicle = ReadVehicle(file, findings);
  if (!run.vehicle) run.vehicle_fault = Reason(findings);
}

/// Reports a result that is no fit's, or of a version that is not understood.
void CheckIsFit(const RunContents& run, const std::filesystem::path& folder, Diagnostics& diagnostics) {
  try {
    FitResultOf(run);
  } catch (const FaultyInput& fault) {
    diagnostics.Add(InFolder(folder, fault.diagnostics().items().front()));
  }
}

/// Says what a folder without a result is.
void ReportNoResult(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  std::error_code failure;
  const auto holds = [&](const char* name) { return std::filesystem::exists(folder / name, failure); };
  const Place place{folder.string()};
  if (std::filesystem::is_empty(folder, failure)) diagnostics.Report(kRunEmpty, place);
  else if (holds("archive.sqlite")) diagnostics.Report(kRunUnfinished, place);
  // A run holds a copy, which refers to files elsewhere.
  else if (holds("study.yaml") && !holds("parameters.csv"))
    diagnostics.Report(kRunNotFitted, place, {(folder / "study.yaml").string()});
  else diagnostics.Report(kRunWithoutResult, place);
}

/// result.json alone; nothing, and reported, where it is not that of a fit.
RunContents ReadResult(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  RunContents run;
  std::error_code failure;
  if (!std::filesystem::is_directory(folder, failure)) {
    diagnostics.Report(kRunNotThere, {folder.string()}, {DidYouMeanFile(folder)});
    return run;
  }
  if (!std::filesystem::exists(folder / kResult, failure)) {
    ReportNoResult(folder, diagnostics);
    return run;
  }
  if (std::optional<std::string> text = ReadTextFile(folder / kResult, diagnostics)) {
    run.files[kResult] = std::move(*text);
    CheckIsFit(run, folder, diagnostics);
  }
  return run;
}

RunContents ReadRun(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  RunContents run = ReadResult(folder, diagnostics);
  if (run.files.empty()) return run;
  for (const std::string& name : OtherFiles()) {
    if (std::error_code failure; !std::filesystem::exists(folder / name, failure)) continue;
    if (std::optional<std::string> text = ReadTextFile(folder / name, diagnostics)) run.files[name] = std::move(*text);
  }
  ReadFittedVehicle(folder / "vehicle.urdf", run);
  return run;
}

/// Reports folders that stand among these twice, in whichever spelling.
void CheckStandOnce(const std::vector<std::filesystem::path>& folders, Diagnostics& diagnostics) {
  std::error_code failure;
  for (auto folder = folders.begin(); folder != folders.end(); ++folder)
    if (std::any_of(folders.begin(), folder, [&](const std::filesystem::path& other) {
          return std::filesystem::equivalent(other, *folder, failure);
        }))
      diagnostics.Report(kRunNamedTwice, {folder->string()});
}

}  // namespace

Diagnostic InFolder(const std::filesystem::path& folder, Diagnostic finding) {
  if (!std::filesystem::path(finding.place.file).has_parent_path())
    finding.place.file = (folder / finding.place.file).string();
  return finding;
}

std::vector<std::pair<std::string, RunContents>> ReadRuns(const std::vector<std::filesystem::path>& folders) {
  Diagnostics diagnostics;
  CheckStandOnce(folders, diagnostics);
  std::vector<std::pair<std::string, RunContents>> runs;
  for (const std::filesystem::path& folder : folders) runs.emplace_back(folder.string(), ReadRun(folder, diagnostics));
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return runs;
}

void RequireFitResult(const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  ReadResult(folder, diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
}

std::vector<std::filesystem::path> RunFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = {folder / kResult, folder / "vehicle.urdf", folder / "archive.sqlite"};
  for (const std::string& name : OtherFiles()) files.push_back(folder / name);
  return files;
}

}  // namespace fourpost
