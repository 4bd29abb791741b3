#include "analysis/files/csv_start.h"

#include <algorithm>
#include <vector>

#include "analysis/files/csv_scanner.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/time_recording.h"
#include "analysis/files/time_stamp.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// Lines above a table are fewer.
constexpr std::size_t kMostLines = 300;
constexpr std::size_t kFewestRows = 3;

bool IsMeasured(std::string field) {
  std::replace(field.begin(), field.end(), ',', '.');
  return ParseNumber(field).has_value() || ParseTimeStamp(field).has_value();
}

bool IsMarked(const std::string& field) { return !field.empty() && (field[0] == '#' || field[0] == '%'); }

std::string_view WithoutMark(std::string_view field) {
  return field.substr(std::min(field.size(), field.find_first_not_of("#% ")));
}

bool IsUnit(const std::string& field) {
  return ParseRecordedUnit(WithoutBrackets(std::string(WithoutMark(field)))).has_value();
}

bool IsNameWithUnit(const std::string& field) {
  const NamedColumn column = SplitColumnName(WithoutMark(field));
  return !column.unit.empty();
}

bool IsNameOfTimes(const std::string& field) {
  return std::find(kTimeColumn.names.begin(), kTimeColumn.names.end(), WithoutMark(field)) != kTimeColumn.names.end();
}

struct LineOfText {
  /// Byte behind the line before.
  std::size_t at = 0;
  /// Without those that are empty behind the last.
  std::size_t fields = 0;
  bool is_row = false;
  /// Has no number.
  bool is_header = false;
  /// Begins as a comment does.
  bool is_marked = false;
  /// Half of its fields are units alone, or names with units.
  bool is_of_units = false;
  bool names_units = false;
  /// One is called as times usually are.
  bool names_times = false;
};

LineOfText LineOf(const CsvRecord& record, std::size_t at) {
  LineOfText line = {.at = at};
  const std::vector<std::string>& fields = record.fields;
  const auto is_empty = [](const std::string& field) { return field.empty(); };
  const auto last = std::find_if_not(fields.rbegin(), fields.rend(), is_empty);
  line.fields = static_cast<std::size_t>(fields.rend() - last);
  const auto first = std::find_if_not(fields.begin(), fields.end(), is_empty);
  line.is_row = first != fields.end() && IsMeasured(*first);
  line.is_header = std::none_of(fields.begin(), fields.end(), IsMeasured);
  line.is_marked = !fields.empty() && IsMarked(fields.front());
  if (!line.is_header || fields.empty()) return line;
  const auto is_half = [&](auto is) {
    return 2 * std::count_if(fields.begin(), last.base(), is) >= last.base() - fields.begin();
  };
  line.is_of_units = is_half(IsUnit);
  line.names_units = is_half(IsNameWithUnit);
  line.names_times = std::any_of(fields.begin(), fields.end(), IsNameOfTimes);
  return line;
}

std::vector<LineOfText> LinesOf(std::string_view text, char separator) {
  std::vector<LineOfText> lines;
  CsvScanner scanner(text, separator);
  CsvRecord record;
  std::size_t at = scanner.at();
  while (lines.size() < kMostLines && scanner.Next(record)) {
    lines.push_back(LineOf(record, at));
    at = scanner.at();
  }
  return lines;
}

struct TablePlace {
  std::size_t columns = 0;
  std::size_t names = 0;
  std::size_t at = 0;
};

/// By the first rows with one number of fields, which no line right above them has without being their header.
std::optional<TablePlace> TableIn(const std::vector<LineOfText>& lines) {
  for (std::size_t i = 1; i + kFewestRows <= lines.size(); ++i) {
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(i);
    const auto is_shorter = [](const LineOfText& a, const LineOfText& b) { return a.fields < b.fields; };
    const auto [least, most] = std::minmax_element(first, first + kFewestRows, is_shorter);
    const std::size_t columns = least->fields;
    // Some rows may have a comment behind the numbers, in a column that has a name.
    const bool are_alike = most->fields == columns || (most->fields == columns + 1 && lines[i - 1].is_header &&
                                                       lines[i - 1].fields == most->fields);
    const auto is_row = [](const LineOfText& line) { return line.is_row; };
    if (columns < 2 || !are_alike || !std::all_of(first, first + kFewestRows, is_row)) continue;
    // A column of comments may have a name and nothing below it.
    const auto is_header = [&](std::size_t k) {
      return lines[k].is_header && (lines[k].fields == columns || lines[k].fields == columns + 1);
    };
    const auto is_comment = [](const LineOfText& line) { return line.is_marked; };
    if (!is_header(i - 1) && std::all_of(lines.begin(), first, is_comment)) return TablePlace{columns, i, lines[i].at};
    if (!is_header(i - 1)) return std::nullopt;
    // Of two such lines the second is one of units, if the first is not about the table that it names.
    const auto is_about = [&](std::size_t k) {
      return !lines[k + 1].is_of_units && (lines[k].is_marked || lines[k + 1].names_units ||
                                           (lines[k + 1].names_times && !lines[k].names_times));
    };
    const std::size_t names = i > 1 && is_header(i - 2) && !is_about(i - 2) ? i - 2 : i - 1;
    return TablePlace{columns, names, lines[names].at};
  }
  return std::nullopt;
}

/// "0,1,2" and "1,2,3"
bool CountsColumns(const std::vector<std::string>& fields) {
  for (const std::size_t from : {0, 1}) {
    std::size_t k = 0;
    while (k < fields.size() && fields[k] == std::to_string(from + k)) ++k;
    if (k == fields.size()) return true;
  }
  return false;
}

}  // namespace

bool IsRowWithoutNames(const CsvRecord& first, CsvScanner below) {
  if (first.fields.size() < 2 || !IsMeasured(first.fields.front()) || CountsColumns(first.fields)) return false;
  CsvRecord record;
  for (std::size_t row = 1; row < kFewestRows; ++row) {
    if (!below.Next(record) || record.fields.size() != first.fields.size()) return false;
    for (std::size_t k = 0; k < first.fields.size(); ++k) {
      // Where nothing was measured a field is empty.
      if (first.fields[k].empty() || record.fields[k].empty()) continue;
      if (IsMeasured(first.fields[k]) != IsMeasured(record.fields[k])) return false;
    }
  }
  return true;
}

std::optional<CsvStart> StartBelowLines(std::string_view text) {
  std::optional<TablePlace> widest;
  for (const char separator : {'\t', ';', ','})
    if (const std::optional<TablePlace> found = TableIn(LinesOf(text, separator));
        found && (!widest || found->columns > widest->columns))
      widest = found;
  if (!widest || widest->names == 0) return std::nullopt;
  const std::size_t at = widest->at;
  return CsvStart{at,
                  1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'))};
}

}  // namespace fourpost
