#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "analysis/files/output_folder.h"
#include "identify/search/evaluation_store.h"
#include "tests/temporary_folder.h"

namespace fourpost {

/// Evaluations in an archive that a program may be writing, or was killed with: of a copy, since whoever opens the file
/// itself takes in its log. None where files of a program at work do not fit together.
inline std::int64_t RowsOfCopy(const std::filesystem::path& archive) {
  const TemporaryFolder folder;
  for (const std::string part : {"", "-wal", "-journal"}) {
    std::error_code not_there;
    std::filesystem::copy_file(archive.string() + part, folder.path() / ("copy.sqlite" + part), not_there);
  }
  try {
    return ReadStoredContent(folder.path() / "copy.sqlite").evaluations;
  } catch (const OutputError&) {
    return 0;
  }
}

}  // namespace fourpost
