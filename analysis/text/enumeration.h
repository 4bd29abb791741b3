#pragma once

#include <span>
#include <string>

namespace fourpost {

/// "a, b and c"
std::string Enumeration(std::span<const std::string> parts);

}  // namespace fourpost
