#include "analysis/files/csv_fault.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/findings.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// Enough to see what most rows are like.
constexpr std::size_t kLooked = 100;

/// "0.1|2|3" with '|', however many blanks are around.
bool IsRowOf(const std::string& text, char separator) {
  std::string blanked = text;
  if (separator != ' ') std::replace(blanked.begin(), blanked.end(), separator, ' ');
  if (separator != ' ' && blanked == text) return false;
  std::size_t numbers = 0;
  for (std::size_t at = blanked.find_first_not_of(' '); at != std::string::npos;) {
    const std::size_t end = std::min(blanked.find(' ', at), blanked.size());
    if (!ParseNumber(blanked.substr(at, end - at))) return false;
    ++numbers;
    at = blanked.find_first_not_of(' ', end);
  }
  return numbers > 1;
}

/// Begins with an object, or with a list of something.
bool IsJson(std::string_view text) {
  constexpr std::string_view kAround = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos || (text[first] != '{' && text[first] != '[')) return false;
  const std::size_t second = text.find_first_not_of(kAround, first + 1);
  if (second == std::string_view::npos) return false;
  return std::string_view(text[first] == '{' ? "\"}" : "{[\"-0123456789").find(text[second]) != std::string_view::npos;
}

std::vector<CsvRecord> FirstOf(CsvScanner& scanner) {
  std::vector<CsvRecord> records;
  CsvRecord record;
  while (records.size() < kLooked && scanner.Next(record)) records.push_back(record);
  return records;
}

std::size_t Fields(const CsvRecord& record, bool ends_with_separator) {
  const std::size_t fields = record.fields.size();
  return ends_with_separator && fields > 1 && record.fields.back().empty() ? fields - 1 : fields;
}

/// How many fields more than half of the records have; 0 when none is so frequent.
std::size_t MostFields(const std::vector<CsvRecord>& records, bool ends_with_separator) {
  std::map<std::size_t, std::size_t> count;
  for (const CsvRecord& record : records) ++count[Fields(record, ends_with_separator)];
  for (const auto& [fields, times] : count)
    if (times > 1 && 2 * times > records.size()) return fields;
  return 0;
}

std::string Columns(std::size_t count) { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

}  // namespace

Found FaultOfText(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return {&kCsvUtf16};
  if (text.find('\0') != std::string_view::npos) return {&kCsvBinary};
  if (IsJson(text)) return {&kCsvJson};
  if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos) return {&kCsvLineEnds};
  return {};
}

Found FaultOfNames(CsvScanner below, std::size_t names, bool ends_with_separator, char separator) {
  const std::vector<CsvRecord> records = FirstOf(below);
  for (const auto& [separating, name] : {std::pair{'|', "'|'"}, {' ', "blanks"}}) {
    // Lambdas of clang 14 cannot capture names of a structured binding.
    const char other = separating;
    if (names == 1 && std::any_of(records.begin(), records.end(), [&](const CsvRecord& record) {
          return record.fields.size() == 1 && IsRowOf(record.fields.front(), other);
        }))
      return {&kCsvSeparator, {name}};
  }
  const std::size_t most = MostFields(records, ends_with_separator);
  if (most == 0 || most == names) return {};
  const std::vector<std::string> words = {Columns(names), std::to_string(most)};
  if (most < names) return {&kCsvTooManyNames, words};
  if (separator == ',' && most == 2 * names) return {&kCsvDecimalCommas, words};
  return {most == names + 1 ? &kCsvLastColumnUnnamed : &kCsvLinesAboveNames, words};
}

}  // namespace fourpost
