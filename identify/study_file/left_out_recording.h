#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A recording that was kept for validation and cannot be used: a fit stands without it.
struct LeftOutRecording {
  std::string name;
  std::filesystem::path file;
  std::string reason;
};

/// Passes on what was found in a recording for validation, faults as warnings that it is left out. Nothing where it has
/// no fault.
std::optional<LeftOutRecording> LeftOutFor(const Diagnostics& found, const std::string& name,
                                           const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace fourpost
