#pragma once

#include <string>
#include <string_view>

namespace fourpost {

// A spreadsheet computes a field that begins with one of = + - @, a channel's name as well as a formula that someone
// meant to be computed. An apostrophe in front says that it is text: it is written there, and read away.

std::string WithTextMark(std::string_view text);
std::string_view WithoutTextMark(std::string_view field);

}  // namespace fourpost
