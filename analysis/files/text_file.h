#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"
#include "analysis/text/found.h"

namespace fourpost {

/// Why this is not read as a file: a pipe, a device, a socket, which may have no end and are read once only. Nothing
/// for all else, also for what is not there.
Found WhyNoFile(const std::filesystem::path& file);

/// The whole file, byte for byte; empty for an empty file. A file that is not there, a folder, what WhyNoFile() names,
/// a file above 1 GiB or a failure while reading is reported with the reason, and gives nothing.
std::optional<std::string> ReadTextFile(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
