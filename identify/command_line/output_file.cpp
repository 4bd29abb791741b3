#include "identify/command_line/output_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "analysis/files/output_folder.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

void RequireWritable(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs) {
  namespace fs = std::filesystem;
  if (file.empty()) return;
  std::error_code failure;
  const auto refuse = [&](const std::string& why) { throw OutputError("cannot write " + file.string() + ": " + why); };
  for (const fs::path& input : inputs)
    if (!input.empty() && fs::equivalent(input, file, failure)) refuse("it is an input; give another file");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failure)) refuse("there is no folder " + folder.string());
  if (fs::is_directory(file, failure)) refuse("it is a folder; name a file");
}

void RequireEnding(const std::string& option, const std::filesystem::path& file, const std::string& what,
                   const std::string& ending) {
  if (file.empty() || file.extension() == ending) return;
  std::filesystem::path named = file;
  Diagnostics faults;
  faults.Error(option, 0,
               "'" + file.string() + "': " + what + " is written to a file in " + ending + ", such as '" +
                   named.replace_extension(ending).string() + "'");
  throw FaultyInput(faults);
}

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  const std::error_code reason(errno == 0 ? EIO : errno, std::generic_category());
  throw OutputError("cannot write " + file.string() + " (" + reason.message() + "); " +
                    WritingRemedy(reason, "allow it or name another folder"));
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
  if (failure) throw OutputError("cannot write " + file.string() + ": " + failure.message());
}

}  // namespace fourpost
