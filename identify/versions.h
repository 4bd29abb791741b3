#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// This program and the libraries that its results depend on: name and version.
std::vector<std::pair<std::string, std::string>> Versions();

/// What the linker made of the running program's code, in hexadecimal digits: equal for equal builds, another one as
/// soon as the code differs. Empty where the linker left none.
std::string BuildId();

}  // namespace fourpost
