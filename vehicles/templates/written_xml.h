#pragma once

#include <string>
#include <string_view>

namespace fourpost {

// Texts of any bytes in XML 1.0 that is written: what is no character of it becomes a blank or U+FFFD.

/// As the value of an attribute in double quotes.
std::string InAttribute(std::string_view text);

/// Within a comment, where two hyphens must not meet: "--load" as "- -load".
std::string InComment(std::string_view text);

}  // namespace fourpost
