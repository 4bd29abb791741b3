#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "analysis/files/csv_scanner.h"

namespace fourpost {

/// Where the table begins in a text that has other lines above it.
struct CsvStart {
  /// Byte and 1-based line of the names of the columns.
  std::size_t at = 0;
  int line = 1;
};

/// The line of names, perhaps with one of units below it, above the first rows of numbers or times of day; of rows that
/// have only comments above them the first row. Nothing where that is the first line, and where there are no such rows.
std::optional<CsvStart> StartBelowLines(std::string_view text);

/// Whether the first record of a table is a row and names no columns: it begins with a number, and the two records
/// below it have numbers and texts in the same fields. Whole numbers that count from 0 or 1 are names. `below`: behind
/// it.
bool IsRowWithoutNames(const CsvRecord& first, CsvScanner below);

}  // namespace fourpost
