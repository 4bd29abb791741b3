#include "analysis/files/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "analysis/files/findings.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// Written to see whether that is possible. A program killed at that moment, or another one, may leave it.
constexpr const char* kProbe = ".fourpost.partial";

[[noreturn]] void ThrowErrno(const fs::path& path) {
  const std::error_code reason(errno, std::generic_category());
  throw fs::filesystem_error("", path, reason);
}

/// "fit.csv: No space left on device".
std::string Reason(const fs::filesystem_error& error) {
  return error.path1().filename().string() + ": " + error.code().message();
}

/// `kind`, unless the disk is full.
[[noreturn]] void ThrowUnusable(const Finding& kind, const fs::path& folder, const std::error_code& code,
                                const std::vector<std::string>& words) {
  if (IsDiskFull(code)) throw OutputError(kDiskFull, {folder.string()}, {words.back()});
  throw OutputError(kind, {folder.string()}, words);
}

Diagnostics OneFinding(const Finding& kind, Place place, const std::vector<std::string>& words) {
  Diagnostics found;
  found.Report(kind, std::move(place), words);
  return found;
}

/// A file or folder that is open for as long as this lives.
class Descriptor {
 public:
  Descriptor(fs::path path, int flags) : path_(std::move(path)), number_(open(path_.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) ThrowErrno(path_);
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void Write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = write(number_, content.data(), content.size());
      if (written < 0 && errno != EINTR) ThrowErrno(path_);
      if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Until this object goes, programs that lock the same file wait; where the file system knows no locks, they do not.
  void Lock() const {
    while (flock(number_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }

  void Flush() const {
    if (fsync(number_) != 0) ThrowErrno(path_);
  }

 private:
  fs::path path_;
  int number_;
};

bool IsEmpty(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return std::all_of(begin(entries), end(entries), [](const auto& entry) {
    const fs::path name = entry.path().filename();
    return name == kProbe || name == kInputsFolder || name == kWatchPage;
  });
}

void CheckContent(const fs::path& folder, const std::string& trace, const std::string& mark) {
  if (IsEmpty(folder) || fs::is_regular_file(folder / mark)) return;
  if (!trace.empty() && fs::is_regular_file(folder / trace)) return;
  throw OutputError(kFolderHoldsFiles, {folder.string()}, {mark});
}

/// By trying: permissions do not show file systems that are read-only, full, or not real.
void CheckWritable(const fs::path& folder, const std::vector<fs::path>& missing, bool keep) {
  const fs::path probe = folder / kProbe;
  std::error_code ignored;
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    RemoveFolders(missing);
    ThrowUnusable(kFolderTakesNoFolder, folder, failure, {missing.front().parent_path().string(), failure.message()});
  }
  try {
    Descriptor(probe, O_WRONLY | O_CREAT | O_TRUNC).Write("probe");
  } catch (const fs::filesystem_error&) {
    fs::remove(probe, ignored);
    RemoveFolders(missing);
    throw;
  }
  fs::remove(probe, ignored);
  if (!keep) RemoveFolders(missing);
}

void CheckUsable(const fs::path& folder, const std::vector<fs::path>& missing, const std::string& trace,
                 const std::string& mark) {
  const fs::path existing = missing.empty() ? folder : missing.front().parent_path();
  if (!fs::is_directory(existing)) throw OutputError(kFolderIsAFile, {existing.string()});
  if (missing.empty()) CheckContent(folder, trace, mark);
  CheckWritable(folder, missing, !trace.empty());
}

fs::path WithoutTrailingSlash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

}  // namespace

OutputError::OutputError(const Finding& kind, Place place, const std::vector<std::string>& words)
    : OutputError(OneFinding(kind, std::move(place), words)) {}

OutputError::OutputError(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.Format()), diagnostics_(std::move(diagnostics)) {}

bool IsDiskFull(const std::error_code& reason) {
  return reason == std::errc::no_space_on_device || reason == std::errc::file_too_large ||
         reason == std::error_code(EDQUOT, std::generic_category());
}

std::vector<fs::path> MissingFolders(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path path = folder; fs::symlink_status(path).type() == fs::file_type::not_found; path = path.parent_path())
    missing.push_back(path);
  std::reverse(missing.begin(), missing.end());
  return missing;
}

void RemoveFolders(const std::vector<fs::path>& outermost_first) {
  std::error_code ignored;
  for (auto folder = outermost_first.rbegin(); folder != outermost_first.rend(); ++folder) fs::remove(*folder, ignored);
}

OutputFolder::OutputFolder(const fs::path& folder, const std::string& trace, const std::string& mark) : mark_(mark) {
  if (folder.empty()) throw OutputError(kFolderNameless, {});
  try {
    // Whole, since a program may change its working directory.
    folder_ = WithoutTrailingSlash(fs::weakly_canonical(fs::absolute(folder)));
    const std::vector<fs::path> missing = MissingFolders(folder_);
    if (!trace.empty() && !fs::exists(folder_ / trace)) new_trace_ = trace;
    CheckUsable(folder_, missing, trace, mark);
    if (!trace.empty()) created_ = missing;
  } catch (const fs::filesystem_error& error) {
    ThrowUnusable(kFolderNotWritable, folder, error.code(), {error.code().message()});
  }
}

void OutputFolder::Add(std::string name, std::string content) {
  const fs::path path = name;
  if (name.empty() || path.filename() != path || name == "." || name == "..")
    throw std::invalid_argument("'" + name + "' is not the name of a file in a result folder");
  if (!content_of_.emplace(std::move(name), std::move(content)).second)
    throw std::invalid_argument("the result file '" + path.string() + "' has been added already");
}

void OutputFolder::Withdraw() const {
  std::error_code ignored;
  if (!new_trace_.empty()) fs::remove(folder_ / new_trace_, ignored);
  RemoveFolders(created_);
}

void OutputFolder::Commit() {
  if (!content_of_.contains(mark_)) throw std::logic_error("results without a " + mark_);
  std::vector<fs::path> created;
  try {
    created = MissingFolders(folder_);
    fs::create_directories(folder_);
    // Two runs into one folder write one after the other.
    const Descriptor folder(folder_, O_RDONLY | O_DIRECTORY);
    folder.Lock();
    CheckTargets();
    WriteFiles();
    RenameFiles();
  } catch (const fs::filesystem_error& error) {
    RemoveTraces(created);
    ThrowUnusable(kResultsNotWritten, folder_, error.code(), {Reason(error)});
  }
}

fs::path OutputFolder::Partial(const std::string& name) const { return folder_ / (name + ".partial"); }

/// Renaming must not fail half-way.
void OutputFolder::CheckTargets() const {
  for (const auto& [name, content] : content_of_)
    if (fs::is_directory(folder_ / name))
      throw fs::filesystem_error("", name, std::make_error_code(std::errc::is_a_directory));
}

void OutputFolder::WriteFiles() const {
  for (const auto& [name, content] : content_of_) {
    const Descriptor file(Partial(name), O_WRONLY | O_CREAT | O_TRUNC);
    file.Write(content);
    file.Flush();
  }
}

void OutputFolder::RenameFiles() const {
  for (const auto& [name, content] : content_of_)
    if (name != mark_) fs::rename(Partial(name), folder_ / name);
  fs::rename(Partial(mark_), folder_ / mark_);
  Descriptor(folder_, O_RDONLY | O_DIRECTORY).Flush();
}

/// Leaves what is not ours; errors here would hide the one that is reported.
void OutputFolder::RemoveTraces(const std::vector<fs::path>& created) const {
  std::error_code ignored;
  for (const auto& [name, content] : content_of_) {
    fs::remove(Partial(name), ignored);
    if (!created.empty()) fs::remove(folder_ / name, ignored);
  }
  RemoveFolders(created);
}

}  // namespace fourpost
