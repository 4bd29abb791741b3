#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// This program and the libraries that its results depend on: name and version.
std::vector<std::pair<std::string, std::string>> Versions();

}  // namespace fourpost
