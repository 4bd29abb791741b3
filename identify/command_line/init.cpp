#include <cstdio>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/init_from.h"
#include "identify/command_line/init_suspension.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/starter_files.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// Throws OutputError unless the folder is new or empty.
void CheckFolder(const fs::path& folder) {
  std::error_code failure;
  if (!fs::exists(folder, failure)) return;
  if (!fs::is_directory(folder, failure)) RefuseToWrite(kStarterFolderIsFile, folder);
  if (!fs::is_empty(folder, failure)) RefuseToWrite(kStarterFolderNotEmpty, folder);
}

/// Throws OutputError for what cannot be a folder: a name too long, a link to itself.
std::vector<fs::path> FoldersToMake(const fs::path& folder) {
  try {
    return MissingFolders(fs::weakly_canonical(fs::absolute(folder)));
  } catch (const fs::filesystem_error& error) {
    RefuseToWrite(folder, error.code());
  }
}

/// All of them or none: the folder is as it was before when a disk is full.
void WriteAll(const fs::path& folder) {
  const std::vector<fs::path> missing = FoldersToMake(folder);
  std::error_code failure;
  try {
    fs::create_directories(folder, failure);
    if (failure) RefuseToWrite(folder, failure);
    for (const StarterFile& file : kStarterFiles) WriteFile(folder / file.name, std::string(file.text));
  } catch (const OutputError&) {
    for (const StarterFile& file : kStarterFiles) fs::remove(folder / file.name, failure);
    RemoveFolders(missing);
    throw;
  }
}

std::string NextSteps(const fs::path& folder) {
  std::string text = "wrote\n";
  for (const StarterFile& file : kStarterFiles) text += "  " + (folder / file.name).string() + "\n";
  return text + "next\n  fourpost check " + (folder / "vehicle.urdf").string() + "\n  fourpost info " +
         (folder / "stepped_sine.csv").string() + "\n  fourpost fit " + (folder / "study.yaml").string() + " -o run\n";
}

std::string InitJson(const fs::path& folder) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const StarterFile& file : kStarterFiles) files.push_back(file.name);
  return JsonText(nlohmann::ordered_json{{"folder", folder.string()}, {"files", files}});
}

}  // namespace

int Run(const InitCommand& command) {
  if (!command.from.empty()) return RunInitFrom(command);
  if (!command.suspension.empty()) return RunInitSuspension(command);
  if (!command.chrono.empty()) return RunInitChrono(command);
  CheckFolder(command.folder);
  WriteAll(command.folder);
  if (command.json) Print(InitJson(command.folder));
  else PrintText(NextSteps(command.folder));
  return kGood;
}

}  // namespace fourpost
