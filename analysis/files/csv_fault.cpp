#include "analysis/files/csv_fault.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// Enough to tell what most rows are like.
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

std::string FaultOfText(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "is written in UTF-16; save it as UTF-8";
  if (text.find('\0') != std::string_view::npos)
    return "is no text but a binary file; export the table as CSV, or as MAT and name it .mat";
  if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
    return "ends its lines with CR alone; save it with line ends of Unix (LF) or Windows (CRLF)";
  return "";
}

std::string FaultOfNames(CsvScanner below, std::size_t names, bool ends_with_separator, char separator) {
  const std::vector<CsvRecord> records = FirstOf(below);
  for (const auto& [separating, name] : {std::pair{'|', "'|'"}, {' ', "blanks"}}) {
    // Lambdas of clang 14 cannot capture names of a structured binding.
    const char other = separating;
    if (names == 1 && std::any_of(records.begin(), records.end(), [&](const CsvRecord& record) {
          return record.fields.size() == 1 && IsRowOf(record.fields.front(), other);
        }))
      return std::string("separates its columns by ") + name + "; save it with commas, semicolons or tabs";
  }
  const std::size_t most = MostFields(records, ends_with_separator);
  if (most == 0 || most == names) return "";
  const std::string seen = "the names have " + Columns(names) + ", the rows below " + std::to_string(most) + ": ";
  if (most < names) return seen + "name as many columns as there are";
  if (separator == ',' && most == 2 * names)
    return seen + "remove the lines above the names; or separate columns by semicolons where decimals have commas";
  return seen + "remove the lines above the names" +
         (most == names + 1 ? ", or name the last column, which may be empty" : "");
}

}  // namespace fourpost
