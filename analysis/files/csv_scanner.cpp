#include "analysis/files/csv_scanner.h"

#include <algorithm>

#include "analysis/files/csv_text_mark.h"
#include "analysis/files/findings.h"

namespace fourpost {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// A tab is none where it separates.
constexpr std::string_view kBlanks = " \r\t";

std::string_view WithoutBlanksBehind(std::string_view text, std::string_view blanks) {
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool IsBlank(const CsvRecord& record) { return !record.fault && record.fields.size() == 1 && record.fields[0].empty(); }

}  // namespace

CsvScanner::CsvScanner(std::string_view text, char separator, int line)
    : size_(text.size()),
      rest_(text),
      ends_{separator, '\n'},
      blanks_(kBlanks.substr(0, separator == '\t' ? 2 : 3)),
      line_(line) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool CsvScanner::Next(CsvRecord& record) {
  while (!rest_.empty()) {
    ReadRecord(record);
    if (!IsBlank(record)) return true;
  }
  return false;
}

void CsvScanner::ReadRecord(CsvRecord& record) {
  record.line = line_;
  record.fields.clear();
  record.fault = {};
  for (;;) {
    record.fields.emplace_back(WithoutTextMark(ReadField(record)));
    if (rest_.empty()) return;
    const bool ends = rest_[0] == '\n';
    rest_.remove_prefix(1);
    if (!ends) continue;
    ++line_;
    return;
  }
}

/// Leaves the separator or line break behind the field.
std::string CsvScanner::ReadField(CsvRecord& record) {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks_), rest_.size()));
  if (rest_.starts_with('"')) return ReadQuoted(record);
  return std::string(WithoutBlanksBehind(Take(ends_), blanks_));
}

std::string CsvScanner::ReadQuoted(CsvRecord& record) {
  const int first_line = line_;
  std::string field;
  do {
    rest_.remove_prefix(1);
    const std::string_view piece = Take("\"");
    line_ += static_cast<int>(std::count(piece.begin(), piece.end(), '\n'));
    field += piece;
    if (rest_.empty()) {
      record.fault = {&kCsvQuoteOpen, {std::to_string(first_line)}};
      return field;
    }
    rest_.remove_prefix(1);
    // A doubled quote stands for one.
    if (rest_.starts_with('"')) field += '"';
  } while (rest_.starts_with('"'));
  if (!WithoutBlanksBehind(Take(ends_), blanks_).empty()) record.fault = {&kCsvTextBehindQuote};
  return field;
}

/// The text up to one of these characters, which stays.
std::string_view CsvScanner::Take(std::string_view until) {
  const std::string_view piece = rest_.substr(0, rest_.find_first_of(until));
  rest_.remove_prefix(piece.size());
  return piece;
}

}  // namespace fourpost
