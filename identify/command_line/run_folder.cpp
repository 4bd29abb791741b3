#include "identify/command_line/run_folder.h"

#include <array>
#include <system_error>

#include "analysis/diagnostics.h"
#include "analysis/text_file.h"
#include "identify/report/run_result.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr const char* kResult = "result.json";
/// What is read as text.
constexpr std::array<const char*, 7> kFiles = {kResult,          "response.csv", "history.csv", "motion.csv",
                                               "validation.csv", "bench.csv",    "study.yaml"};

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

RunContents ReadRun(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  RunContents run;
  if (!std::filesystem::is_directory(folder)) {
    diagnostics.Error(folder.string(), 0, "is no folder; give one that `fourpost fit -o` wrote");
    return run;
  }
  if (!std::filesystem::exists(folder / kResult)) {
    diagnostics.Error(
        folder.string(), 0,
        "holds no result.json, which a fit writes at its end; run `fourpost fit` with -o on this folder again, "
        "it goes on from its archive");
    return run;
  }
  for (const char* name : kFiles) {
    if (!std::filesystem::exists(folder / name)) continue;
    if (std::optional<std::string> text = ReadTextFile(folder / name, diagnostics)) run.files[name] = std::move(*text);
  }
  if (run.files.contains(kResult)) CheckIsFit(run, folder, diagnostics);
  ReadFittedVehicle(folder / "vehicle.urdf", run);
  return run;
}

}  // namespace

std::vector<std::pair<std::string, RunContents>> ReadRuns(const std::vector<std::filesystem::path>& folders) {
  Diagnostics diagnostics;
  std::vector<std::pair<std::string, RunContents>> runs;
  for (const std::filesystem::path& folder : folders) runs.emplace_back(folder.string(), ReadRun(folder, diagnostics));
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return runs;
}

std::vector<std::filesystem::path> RunFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = {folder / "vehicle.urdf", folder / "archive.sqlite"};
  for (const char* name : kFiles) files.push_back(folder / name);
  return files;
}

}  // namespace fourpost
