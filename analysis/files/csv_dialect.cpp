#include "analysis/files/csv_dialect.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "analysis/files/csv_scanner.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::array<char, 3> kSeparators = {'\t', ';', ','};

/// Fields of the next line that is not blank; 0 at the end.
std::size_t FieldsOfNext(CsvScanner& scanner) {
  CsvRecord record;
  return scanner.Next(record) ? record.fields.size() : 0;
}

char SeparatorOf(std::string_view text) {
  char most_often = ',';
  std::size_t most = 1;
  for (const char separator : kSeparators) {
    CsvScanner scanner(text, separator);
    const std::size_t first = FieldsOfNext(scanner);
    if (first > 1 && first == FieldsOfNext(scanner)) return separator;
    if (first <= most) continue;
    most = first;
    most_often = separator;
  }
  return most_often;
}

/// The decimal sign of a number such as "1,5" or "-2.5e3"; nothing for one without, and for other text.
std::optional<char> DecimalSign(std::string text) {
  const std::size_t at = text.find_first_of(",.");
  if (at == std::string::npos) return std::nullopt;
  const char sign = text[at];
  text[at] = '.';
  return ParseNumber(text) ? std::optional(sign) : std::nullopt;
}

}  // namespace

CsvDialect DialectOf(std::string_view text) {
  CsvDialect dialect = {.separator = SeparatorOf(text)};
  if (dialect.separator == ',') return dialect;
  CsvScanner scanner(text, dialect.separator);
  CsvRecord record;
  while (scanner.Next(record))
    for (const std::string& field : record.fields)
      if (const std::optional<char> sign = DecimalSign(field)) {
        dialect.decimal = *sign;
        return dialect;
      }
  return dialect;
}

}  // namespace fourpost
