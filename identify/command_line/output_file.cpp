#include "identify/command_line/output_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "analysis/files/findings.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/diagnostics.h"
#include "identify/command_line/findings.h"

namespace fourpost {

void RefuseToWrite(const Finding& finding, const std::filesystem::path& place, const std::vector<std::string>& words) {
  throw OutputError(Format({std::string(finding.id()), finding.severity(), {place.string()}, finding.Message(words)}));
}

void RefuseToWrite(const std::filesystem::path& place, const std::error_code& reason) {
  RefuseToWrite(IsDiskFull(reason) ? kDiskFull : kOutputNotWritten, place, {reason.message()});
}

void RequireWritable(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs) {
  namespace fs = std::filesystem;
  if (file.empty()) return;
  std::error_code failure;
  for (const fs::path& input : inputs)
    if (!input.empty() && fs::equivalent(input, file, failure)) RefuseToWrite(kOutputIsInput, file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failure)) RefuseToWrite(kOutputWithoutFolder, file, {folder.string()});
  if (fs::is_directory(file, failure)) RefuseToWrite(kOutputIsFolder, file);
}

void RequireEnding(const std::string& option, const std::filesystem::path& file, const std::string& what,
                   const std::string& ending) {
  if (file.empty() || file.extension() == ending) return;
  std::filesystem::path named = file;
  named.replace_extension(ending);
  Refuse(kOutputEnding, Place::Option(option), {file.string(), what, ending, named.string()});
}

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  const std::error_code reason(errno == 0 ? EIO : errno, std::generic_category());
  RefuseToWrite(file, reason);
}

void ReplaceFile(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path partial = file.string() + ".partial";
  std::error_code failure;
  try {
    WriteFile(partial, text);
  } catch (const OutputError&) {
    std::filesystem::remove(partial, failure);
    throw;
  }
  std::filesystem::rename(partial, file, failure);
  if (failure) RefuseToWrite(file, failure);
}

}  // namespace fourpost
