#pragma once

#include <string>
#include <string_view>

namespace fourpost {

/// The text with U+FFFD in place of each byte that belongs to no character of UTF-8 (The Unicode Standard, table 3-7):
/// names of files may be any bytes, documents may not.
std::string ValidUtf8(std::string_view text);

/// Text of a file that does not say how it is written: as it is where that is UTF-8, else of Latin-1, in UTF-8.
std::string Utf8OfEither(std::string_view text);

}  // namespace fourpost
