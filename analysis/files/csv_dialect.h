#pragma once

#include <string_view>

namespace fourpost {

/// How a measurement system writes a table: 1,5 is a number where another character separates columns.
struct CsvDialect {
  /// ',', ';' or a tab.
  char separator = ',';
  /// '.' or ','
  char decimal = '.';
};

/// The separator is the first of tab, semicolon and comma that parts the first two lines into as many fields, two at
/// least; else the one that stands most often in the first. Decimals are those of the first number that has some.
/// What stands between quotes does not count.
CsvDialect DialectOf(std::string_view text);

}  // namespace fourpost
