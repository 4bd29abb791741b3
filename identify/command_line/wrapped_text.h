#pragma once

#include <cstddef>
#include <string>

namespace fourpost {

/// The text with lines longer than `width` characters broken at blanks and indented as their last column is. Commands
/// to copy, indented lines that begin with "fourpost", stay whole.
std::string Wrapped(const std::string& text, std::size_t width);

}  // namespace fourpost
