#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/report/comparison_page.h"
#include "identify/report/report_page.h"
#include "identify/report/run_result.h"

namespace fourpost {
namespace {

/// As a fault of the run's folder.
[[noreturn]] void Refuse(const std::filesystem::path& folder, const std::string& reason) {
  Diagnostics faults;
  faults.Error((folder / "result.json").string(), 0, reason);
  throw FaultyInput(faults);
}

/// As faults of files of these folders, and what to do.
[[noreturn]] void RefuseTables(const std::vector<std::filesystem::path>& folders, const FaultyInput& fault) {
  Diagnostics faults;
  for (const Diagnostic& item : fault.diagnostics().items()) {
    const bool is_named = std::filesystem::path(item.place.file).has_parent_path();
    const bool tells = item.message.find("fit") != std::string::npos;
    faults.Error(is_named ? item.place.file : (folders.front() / item.place.file).string(), item.place.line,
                 item.message + (tells ? "" : "; the file is damaged: run `fourpost fit` with -o on its folder again"));
  }
  throw FaultyInput(faults);
}

/// Of one run its report, of several their comparison. Throws FaultyInput.
std::string PageOf(std::vector<std::pair<std::string, RunContents>> runs,
                   const std::vector<std::filesystem::path>& folders) {
  try {
    if (runs.size() > 1) return ComparisonPage(std::move(runs));
    return ReportPage(runs.front().second);
  } catch (const FaultyInput& fault) {
    RefuseTables(folders, fault);
  } catch (const nlohmann::json::exception& fault) {
    Refuse(folders.front(), NotUnderstood(fault));
  }
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
  std::vector<std::pair<std::string, RunContents>> runs = ReadRuns(command.runs);
  std::vector<std::filesystem::path> read;
  for (const std::filesystem::path& folder : command.runs)
    for (const std::filesystem::path& name : RunFiles(folder)) read.push_back(name);
  RequireWritable(file, read);
  RequireEnding("--output", file, "a page", ".html");
  if (runs.size() == 1 && !runs.front().second.vehicle_fault.empty())
    std::fprintf(stderr, "the report does not show the vehicle: %s\n", runs.front().second.vehicle_fault.c_str());
  const std::string page = PageOf(std::move(runs), command.runs);
  ReplaceFile(file, page);
  if (command.json) Print(JsonText(nlohmann::ordered_json{{"file", file.string()}, {"bytes", page.size()}}));
  else Print(file.string() + '\n');
  return kGood;
}

}  // namespace fourpost
