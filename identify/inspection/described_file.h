#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// What `fourpost info` says of a file.
struct DescribedFile {
  std::string file;
  /// For the terminal.
  std::string text;
  /// A member of `files` of `fourpost info --json`.
  nlohmann::ordered_json json;
  /// Of a study: what its channels say against each other.
  Diagnostics findings;
  /// Of a study whose recordings contradict what it says of posts and amplitudes: a fit refuses it, and there is no
  /// audit.
  bool is_refused = false;
};

/// A recording, or a study, whose channels are compared with each other. Adds every fault to `faults`; nothing where it
/// cannot be read.
std::optional<DescribedFile> DescribeFile(const std::filesystem::path& file, Diagnostics& faults);

}  // namespace fourpost
