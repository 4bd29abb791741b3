#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A place where results cannot be written; `what()` names it and says why and what to do.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  OutputError(const Finding& kind, Place place, const std::vector<std::string>& words = {});
  /// Empty where it was made of a text.
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  explicit OutputError(Diagnostics diagnostics);

  Diagnostics diagnostics_;
};

/// Whether the system refuses to write for want of room.
bool IsDiskFull(const std::error_code& reason);

/// The folders that must be created for this one, an absolute path, to exist, the outermost first.
std::vector<std::filesystem::path> MissingFolders(const std::filesystem::path& folder);

/// Those that are empty, the innermost first.
void RemoveFolders(const std::vector<std::filesystem::path>& outermost_first);

/// Where a folder of results keeps inputs of its own, such as arrays that were fitted; no results of an earlier run.
inline constexpr const char* kInputsFolder = "inputs";

/// How a run gets on, in a browser; no result either.
inline constexpr const char* kWatchPage = "watch.html";

/// A folder of results that is written completely or not at all. A file, `result.json` unless another is named, marks
/// it as ours, and is put there last. Nothing is on disk before Commit.
class OutputFolder {
 public:
  /// Checks at once what hours of work would otherwise find out at their end. Throws OutputError unless the folder can
  /// be created, or is empty, or holds the `mark` of an earlier run, and may be written to. With a `trace`, a file
  /// that the run itself keeps there from its beginning, that file marks the folder as well, and the folder is created
  /// at once.
  explicit OutputFolder(const std::filesystem::path& folder, const std::string& trace = "",
                        const std::string& mark = "result.json");

  /// Throws std::invalid_argument for a name that has been added already or is not that of a file in the folder.
  void Add(std::string name, std::string content);

  /// Of a run that is refused: removes its trace and the folders that were created for it, unless they were there
  /// before.
  void Withdraw() const;

  /// Writes the files, in the place of an earlier run's of the same names; its other files stay. When that fails the
  /// folder is as it was before, and OutputError is thrown. Throws std::logic_error without the `mark`.
  void Commit();

 private:
  std::filesystem::path Partial(const std::string& name) const;
  void CheckTargets() const;
  void WriteFiles() const;
  void RenameFiles() const;
  void RemoveTraces(const std::vector<std::filesystem::path>& created) const;

  std::filesystem::path folder_;
  std::string mark_;
  /// Created at once, the outermost first.
  std::vector<std::filesystem::path> created_;
  /// Empty where it was there before.
  std::string new_trace_;
  std::map<std::string, std::string> content_of_;
};

}  // namespace fourpost
