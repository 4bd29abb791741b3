#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fourpost {

/// Where the table begins in a text that has other lines above it.
struct CsvStart {
  /// Byte and 1-based line of the names of the columns.
  std::size_t at = 0;
  int line = 1;
};

/// The line of names, perhaps with one of units below it, above the first rows of numbers or times of day; nothing
/// where that is the first line, and where there are no such rows.
std::optional<CsvStart> StartBelowLines(std::string_view text);

}  // namespace fourpost
