#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fourpost {

/// Characters, not bytes, of UTF-8 text.
std::size_t Width(std::string_view text);

/// The text, or as many of its words as go with "..." into this many characters.
std::string CutToWidth(const std::string& text, std::size_t width);

}  // namespace fourpost
