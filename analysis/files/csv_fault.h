#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/files/csv_scanner.h"
#include "analysis/text/found.h"

namespace fourpost {

/// Why the text as a whole is no table: UTF-16, binary, line ends that are none.
Found FaultOfText(std::string_view text);

/// Why the names of a table cannot be those of its rows: another separator, lines above the names. The scanner stands
/// below the names; `ends_with_separator` as in the names' line.
Found FaultOfNames(CsvScanner below, std::size_t names, bool ends_with_separator, char separator);

}  // namespace fourpost
