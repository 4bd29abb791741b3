#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "analysis/text/finding.h"

namespace fourpost {

/// Throws OutputError about a place where results cannot be written.
[[noreturn]] void RefuseToWrite(const Finding& finding, const std::filesystem::path& place,
                                const std::vector<std::string>& words = {});

/// Likewise, for the reason that the system gives.
[[noreturn]] void RefuseToWrite(const std::filesystem::path& place, const std::error_code& reason);

/// Before the work, so that none is in vain: throws OutputError for a file that is one of the inputs, that lies in no
/// folder, or that is one. An empty path is none.
void RequireWritable(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs);

/// Throws FaultyInput, as a fault of the option, for a file whose name does not end in the ending of `what`, as ".csv"
/// of "a table". An empty path is none.
void RequireEnding(const std::string& option, const std::filesystem::path& file, const std::string& what,
                   const std::string& ending);

/// Throws OutputError when that fails.
void WriteFile(const std::filesystem::path& file, const std::string& text);

/// Likewise; an older file stays then.
void ReplaceFile(const std::filesystem::path& file, const std::string& text);

}  // namespace fourpost
