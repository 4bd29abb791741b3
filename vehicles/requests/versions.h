#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// This program and the libraries that its results depend on: name and version.
std::vector<std::pair<std::string, std::string>> Versions();

/// Build identifier of the running program, in hexadecimal digits: equal for equal builds, different as soon as the
/// code differs. The one left by the linker, else ProgramDigest().
std::string BuildId();

/// SHA-256 of the running program's file. Throws std::runtime_error if it cannot be read.
std::string ProgramDigest();

}  // namespace fourpost
