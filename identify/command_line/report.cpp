#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "analysis/text_file.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/model_ranking.h"
#include "identify/report/comparison_page.h"
#include "identify/report/report_page.h"
#include "identify/report/run_result.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr const char* kResult = "result.json";
/// What a report reads as text.
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

/// Throws FaultyInput for a folder that is not that of a run.
RunContents ReadRun(const std::filesystem::path& folder) {
  Diagnostics faults;
  if (!std::filesystem::is_directory(folder)) {
    faults.Error(folder.string(), 0, "is no folder; a report needs one that `fourpost fit -o` wrote");
    throw FaultyInput(faults);
  }
  if (!std::filesystem::exists(folder / kResult)) {
    faults.Error(
        folder.string(), 0,
        "holds no result.json, which a fit writes at its end; run `fourpost fit` with -o on this folder again, "
        "it goes on from its archive");
    throw FaultyInput(faults);
  }
  RunContents run;
  for (const char* name : kFiles) {
    if (!std::filesystem::exists(folder / name)) continue;
    if (std::optional<std::string> text = ReadTextFile(folder / name, faults)) run.files[name] = std::move(*text);
  }
  if (faults.HasErrors()) throw FaultyInput(faults);
  ReadFittedVehicle(folder / "vehicle.urdf", run);
  return run;
}

/// As a fault of the run's folder.
[[noreturn]] void Refuse(const std::filesystem::path& folder, const std::string& reason) {
  Diagnostics faults;
  faults.Error((folder / kResult).string(), 0, reason);
  throw FaultyInput(faults);
}

/// Throws FaultyInput for a result that is no fit's, or of a version that is not understood.
void RequireFit(const RunContents& run, const std::filesystem::path& folder) {
  try {
    FitResultOf(run);
  } catch (const FaultyInput& fault) {
    Refuse(folder, fault.diagnostics().items().front().message);
  }
}

/// `fourpost rank` knows dampers fitted to the same recordings.
std::optional<ModelRanking> RankingOf(const std::vector<std::filesystem::path>& folders) {
  Diagnostics not_ranked;
  std::vector<FittedModel> models = ReadFittedModels(folders, not_ranked);
  if (not_ranked.HasErrors()) return std::nullopt;
  return Rank(std::move(models));
}

/// Of one run its report, of several their comparison. Throws FaultyInput.
std::string PageOf(std::vector<std::pair<std::string, RunContents>> runs,
                   const std::vector<std::filesystem::path>& folders) {
  if (runs.size() > 1) return ComparisonPage(std::move(runs), RankingOf(folders));
  try {
    return ReportPage(runs.front().second);
  } catch (const nlohmann::json::exception& fault) {
    Refuse(folders.front(), NotUnderstood(fault));
  }
}

/// An older report stays when that fails. Throws OutputError.
void Replace(const std::filesystem::path& file, const std::string& page) {
  const std::filesystem::path partial = file.string() + ".partial";
  std::error_code failure;
  try {
    WriteFile(partial, page);
  } catch (const OutputError&) {
    std::filesystem::remove(partial, failure);
    throw;
  }
  std::filesystem::rename(partial, file, failure);
  if (failure) throw OutputError("cannot write " + file.string() + ": " + failure.message());
}

/// A page of several runs belongs into none of their folders.
void RequireOutput(const ReportCommand& command) {
  if (!command.output.empty()) return;
  Diagnostics faults;
  faults.Error("--output", 0,
               "is wanted for a page that compares " + std::to_string(command.runs.size()) +
                   " runs: -o FILE, such as -o models.html");
  throw FaultyInput(faults);
}

}  // namespace

int Run(const ReportCommand& command) {
  if (command.runs.size() > 1) RequireOutput(command);
  const std::filesystem::path file = command.output.empty() ? command.runs.front() / "report.html" : command.output;
  std::vector<std::filesystem::path> read;
  std::vector<std::pair<std::string, RunContents>> runs;
  for (const std::filesystem::path& folder : command.runs) {
    for (const char* name : {"vehicle.urdf", "archive.sqlite"}) read.push_back(folder / name);
    for (const char* name : kFiles) read.push_back(folder / name);
    runs.emplace_back(folder.string(), ReadRun(folder));
    RequireFit(runs.back().second, folder);
  }
  RequireWritable(file, read);
  if (runs.size() == 1 && !runs.front().second.vehicle_fault.empty())
    std::fprintf(stderr, "the report does not show the vehicle: %s\n", runs.front().second.vehicle_fault.c_str());
  const std::string page = PageOf(std::move(runs), command.runs);
  Replace(file, page);
  if (command.json) Print(nlohmann::ordered_json{{"file", file.string()}, {"bytes", page.size()}}.dump(2) + '\n');
  else Print(file.string() + '\n');
  return kGood;
}

}  // namespace fourpost
