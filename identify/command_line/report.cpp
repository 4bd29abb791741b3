#include <set>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/experiments/findings.h"
#include "identify/report/comparison_page.h"
#include "identify/report/findings.h"
#include "identify/report/report_page.h"
#include "identify/report/run_result.h"
#include "identify/study/experiment_kinds.h"

namespace fourpost {
namespace {

/// Whether it says itself how to get a file that is whole.
bool SaysToFit(const Diagnostic& fault) {
  return fault.id == kFitColumnMissing.id() || fault.id == kResultNotUnderstood.id();
}

/// As faults of files of these folders, and what to do.
[[noreturn]] void RefuseTables(const std::vector<std::filesystem::path>& folders, const FaultyInput& fault) {
  Diagnostics faults;
  std::set<std::string> damaged;
  for (const Diagnostic& item : fault.diagnostics().items()) {
    const Diagnostic found = InFolder(folders.front(), item);
    faults.Add(found);
    if (!SaysToFit(found) && damaged.insert(found.place.file).second)
      faults.Report(kRunFileDamaged, {found.place.file});
  }
  throw FaultyInput(faults);
}

/// Of one run its report, of several their comparison. Throws FaultyInput.
std::string PageOf(std::vector<std::pair<std::string, RunContents>> runs,
                   const std::vector<std::filesystem::path>& folders) {
  try {
    if (runs.size() > 1) return ComparisonPage(std::move(runs), AllExperimentReports());
    return ReportPage(runs.front().second, AllExperimentReports());
  } catch (const FaultyInput& fault) {
    RefuseTables(folders, fault);
  } catch (const nlohmann::json::exception& fault) {
    RefuseResult((folders.front() / "result.json").string(), fault);
  }
}

/// A page of several runs belongs into none of their folders.
void RequireOutput(const ReportCommand& command) {
  if (command.output.empty())
    Refuse(kPageWithoutName, Place::Option("--output"), {std::to_string(command.runs.size())});
}

}  // namespace

int Run(const ReportCommand& command) {
  if (command.runs.size() > 1) RequireOutput(command);
  const std::filesystem::path file = command.output.empty() ? command.runs.front() / "report.html" : command.output;
  std::vector<std::pair<std::string, RunContents>> runs = ReadRuns(command.runs);
  std::vector<std::filesystem::path> read;
  for (const std::filesystem::path& folder : command.runs)
    for (const std::filesystem::path& name : RunFiles(folder)) read.push_back(name);
  RequireWritable(file, read);
  RequireEnding("--output", file, "a page", ".html");
  if (runs.size() == 1 && !runs.front().second.vehicle_fault.empty())
    Tell(kVehicleNotShown, {command.runs.front().string()}, {runs.front().second.vehicle_fault});
  const std::string page = PageOf(std::move(runs), command.runs);
  ReplaceFile(file, page);
  if (command.json) Print(JsonText(nlohmann::ordered_json{{"file", file.string()}, {"bytes", page.size()}}));
  else Print(file.string() + '\n');
  return kGood;
}

}  // namespace fourpost
