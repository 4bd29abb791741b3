#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "analysis/text_file.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/report/report_page.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr const char* kResult = "result.json";
/// What a report reads as text.
constexpr std::array<const char*, 5> kFiles = {kResult, "response.csv", "history.csv", "motion.csv", "bench.csv"};

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

/// Throws FaultyInput for a result that is no fit's, or of a version that is not understood.
std::string PageOf(const RunContents& run, const std::filesystem::path& folder) {
  try {
    return ReportPage(run);
  } catch (const nlohmann::json::exception& fault) {
    Diagnostics faults;
    faults.Error(
        (folder / kResult).string(), 0,
        std::string("is not understood, as of another version of fourpost (") + fault.what() +
            "); run `fourpost fit` with -o on this folder again, it takes evaluations from the archive where it can");
    throw FaultyInput(faults);
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

}  // namespace

int Run(const ReportCommand& command) {
  const std::filesystem::path file = command.output.empty() ? command.run / "report.html" : command.output;
  std::vector<std::filesystem::path> paths = {command.run / "vehicle.urdf", command.run / "archive.sqlite"};
  for (const char* name : kFiles) paths.push_back(command.run / name);
  const RunContents run = ReadRun(command.run);
  RequireWritable(file, paths);
  if (!run.vehicle_fault.empty())
    std::fprintf(stderr, "the report does not show the vehicle: %s\n", run.vehicle_fault.c_str());
  const std::string page = PageOf(run, command.run);
  Replace(file, page);
  if (command.json) Print(nlohmann::ordered_json{{"file", file.string()}, {"bytes", page.size()}}.dump(2) + '\n');
  else Print(file.string() + '\n');
  return kGood;
}

}  // namespace fourpost
