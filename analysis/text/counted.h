#pragma once

#include <string>

namespace fourpost {

/// "1 post", "4 posts"
template <typename Count>
std::string Counted(Count count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

}  // namespace fourpost
