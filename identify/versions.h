#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// This program and the libraries that its results depend on: name and version.
std::vector<std::pair<std::string, std::string>> Versions();

/// Of the running program, in hexadecimal digits: equal for equal builds, another one as soon as the code differs. What
/// the linker left for it, else ProgramDigest().
std::string BuildId();

/// SHA-256 of the running program's file. Throws std::runtime_error when it cannot be read.
std::string ProgramDigest();

}  // namespace fourpost
