#include "analysis/files/csv_writer.h"

#include <cmath>
#include <stdexcept>

#include "analysis/files/csv_text_mark.h"
#include "analysis/text/number.h"
#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

bool NeedsQuotes(std::string_view text) {
  if (text.find_first_of(",\"\r\n") != std::string_view::npos) return true;
  return text.starts_with(' ') || text.ends_with(' ') || text.starts_with('\t') || text.ends_with('\t');
}

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// A number is no formula, whatever it begins with.
std::string AsText(const std::string& text) { return ParseNumber(text) ? text : WithTextMark(text); }

}  // namespace

CsvWriter::CsvWriter(const std::vector<std::string>& columns) : columns_(columns.size()) {
  if (columns.empty()) throw std::invalid_argument("a table needs a column");
  for (const std::string& column : columns) Add(column);
}

CsvWriter& CsvWriter::Add(double number) {
  if (std::isinf(number)) throw std::invalid_argument("an infinite number in a table");
  AddField(std::isnan(number) ? std::string() : FormatNumber(number));
  return *this;
}

CsvWriter& CsvWriter::Add(std::string_view text) {
  const std::string field = AsText(ValidUtf8(text));
  AddField(NeedsQuotes(field) ? Quoted(field) : field);
  return *this;
}

const std::string& CsvWriter::text() const {
  if (fields_in_row_ != 0) throw std::logic_error("the last row of the table is not full");
  return text_;
}

void CsvWriter::AddField(std::string_view field) {
  if (fields_in_row_ > 0) text_ += ',';
  text_ += field;
  ++fields_in_row_;
  if (fields_in_row_ < columns_) return;
  text_ += '\n';
  fields_in_row_ = 0;
}

}  // namespace fourpost
