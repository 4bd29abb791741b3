#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/files/csv_scanner.h"

namespace fourpost {

/// Why the text as a whole is no table, and what to do: UTF-16, binary, line ends that are none. Empty when it may be.
std::string FaultOfText(std::string_view text);

/// Why the names of a table cannot be those of its rows, and what to do: another separator, lines above the names.
/// Empty when they may be. The scanner stands below the names; `ends_with_separator` as in the names' line.
std::string FaultOfNames(CsvScanner below, std::size_t names, bool ends_with_separator, char separator);

}  // namespace fourpost
