#include "identify/command_line/run_folder.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "analysis/files/near_file.h"
#include "analysis/files/text_file.h"
#include "analysis/text/diagnostics.h"
#include "identify/report/run_result.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr const char* kResult = "result.json";
/// What is read as text.
constexpr std::array<const char*, 6> kOtherFiles = {"response.csv",   "history.csv", "motion.csv",
                                                    "validation.csv", "bench.csv",   "study.yaml"};

/// The first finding, which is what keeps a vehicle from being shown.
std::string Reason(const Diagnostics& findings) {
  return findings.items().empty() ? "vehicle.urdf cannot be read" : findings.items().front().message;
}

void ReadFittedVehicle(const std::filesystem::path& file, RunContents& run) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) {
    run.vehicle_fault = "the folder has no vehicle.urdf";
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
    diagnostics.Error((folder / kResult).string(), 0, fault.diagnostics().items().front().message);
  }
}

/// What a folder without a result is, and what to do.
std::string WithoutResult(const std::filesystem::path& folder) {
  std::error_code failure;
  const auto holds = [&](const char* name) { return std::filesystem::exists(folder / name, failure); };
  if (std::filesystem::is_empty(folder, failure)) return "is an empty folder; give one that `fourpost fit -o` wrote";
  if (holds("archive.sqlite"))
    return "holds no result.json, which a fit writes at its end; run `fourpost fit` with -o on this folder again, it "
           "goes on from its archive";
  // A run holds a copy, which refers to files elsewhere.
  if (holds("study.yaml") && !holds("parameters.csv"))
    return "holds a study and no results; fit it first, by `fourpost fit " + (folder / "study.yaml").string() +
           " -o run`, and give that folder";
  return "holds no result.json: it is none that `fourpost fit -o` wrote, or not all of it; give another one, or fit "
         "anew";
}

/// result.json alone; nothing, and reported, where it is not that of a fit.
RunContents ReadResult(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  RunContents run;
  std::error_code failure;
  if (!std::filesystem::is_directory(folder, failure)) {
    diagnostics.Error(folder.string(), 0,
                      "is no folder; give one that `fourpost fit -o` wrote" + DidYouMeanFile(folder));
    return run;
  }
  if (!std::filesystem::exists(folder / kResult, failure)) {
    diagnostics.Error(folder.string(), 0, WithoutResult(folder));
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
  for (const char* name : kOtherFiles) {
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
      diagnostics.Error(folder->string(), 0, "is given twice; a run is not compared with itself");
}

}  // namespace

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
  for (const char* name : kOtherFiles) files.push_back(folder / name);
  return files;
}

}  // namespace fourpost
