#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>

namespace fourpost::api {

/// What a recording or a study holds, and what is doubtful about it.
struct Info {
  /// A member of `files` of `fourpost info --json`: of a recording its channels with units, spans and levels, and why a
  /// fit would refuse it; of a study its files and the audit of the rig.
  std::string json;
  /// As the program prints it, a line and more.
  std::string text;
  /// Of a study: channels that contradict the others.
  std::vector<Finding> warnings;
};

/// Describes a recording, or a study, whose channels are compared with each other without a fit. Throws Error.
Info Describe(const std::filesystem::path& file);

}  // namespace fourpost::api
