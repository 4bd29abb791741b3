#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/diagnostics.h"

namespace fourpost {

/// The whole file, byte for byte; empty for an empty file. A file that is not there, a folder or a failure while
/// reading is reported with the system's reason, and gives nothing.
std::optional<std::string> ReadTextFile(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
