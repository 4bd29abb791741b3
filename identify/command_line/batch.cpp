#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "identify/command_line/batch_findings.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/inspection/file_kind.h"

namespace fourpost {
namespace {

constexpr const char* kPackage = "fourpost_batch";

std::filesystem::path ThisProgram() {
  std::error_code failure;
  return std::filesystem::read_symlink("/proc/self/exe", failure);
}

/// The folder of the Python package: beside the program where that was built, or installed with it. Throws FaultyInput.
std::filesystem::path PackageFolder(const std::filesystem::path& program) {
  const std::filesystem::path folder = program.parent_path();
  std::error_code failure;
  for (const std::filesystem::path& place : {folder / "python", folder / "../share/fourpost/python"})
    if (std::filesystem::exists(place / kPackage / "__main__.py", failure)) return place;
  Refuse(kBatchWithoutPackage, {}, {(folder / "python" / kPackage).string()});
}

/// Debian's, which its packages belong to, whatever stands before it on PATH.
std::string PythonName() {
  if (const char* const chosen = std::getenv("FOURPOST_PYTHON"); chosen != nullptr && *chosen != '\0') return chosen;
  constexpr const char* kOfSystem = "/usr/bin/python3";
  return access(kOfSystem, X_OK) == 0 ? kOfSystem : "python3";
}

void AddToPythonPath(const std::filesystem::path& folder) {
  const char* const others = std::getenv("PYTHONPATH");
  const std::string path = folder.string() + (others != nullptr && *others != '\0' ? ":" + std::string(others) : "");
  setenv("PYTHONPATH", path.c_str(), 1);
}

std::vector<std::string> WordsOf(const BatchCommand& command, const std::string& program) {
  std::vector<std::string> words = {"-m", kPackage, "--program", program};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.push_back(std::string(name) + "=" + value);
  };
  add("--plan", command.plan.string());
  add("--output", command.output.string());
  add("--on", command.on);
  add("--workers", std::to_string(command.workers));
  add("--tries", std::to_string(command.tries));
  add("--slurm", command.slurm);
  add("--task", command.task.string());
  if (command.ship) words.emplace_back("--ship");
  if (command.list) words.emplace_back("--list");
  if (command.unpack) words.emplace_back("--unpack");
  if (command.json) words.emplace_back("--json");
  return words;
}

/// What one needs of the others. Throws FaultyInput.
void CheckIsWhole(const BatchCommand& command) {
  if (!command.task.empty()) return;
  if (command.plan.empty()) Refuse(kBatchWithoutPlan, Place::Option("PLAN"));
  RequireStudyFile(command.plan);
  if (command.output.empty() && !command.list) Refuse(kBatchWithoutOutput, Place::Option("--output"));
}

}  // namespace

int Run(const BatchCommand& command) {
  CheckIsWhole(command);
  const std::filesystem::path program = ThisProgram();
  AddToPythonPath(PackageFolder(program));
  std::string python = PythonName();
  std::vector<std::string> words = WordsOf(command, program.string());
  std::vector<char*> arguments = {python.data()};
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(python.c_str(), arguments.data());
  Refuse(kBatchWithoutPython, {}, {python, std::strerror(errno)});
}

}  // namespace fourpost
