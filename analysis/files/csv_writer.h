#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// Builds a comma-separated table field by field: `CsvWriter csv({"channel", "gain"}); csv.Add("a_cg").Add(1.02);`.
/// A row ends by itself when it is full. Numbers have the fewest digits that read back to the same double.
class CsvWriter {
 public:
  /// Throws std::invalid_argument without a column.
  explicit CsvWriter(const std::vector<std::string>& columns);

  /// NaN becomes an empty field. Throws std::invalid_argument for an infinite number, which no reader takes.
  CsvWriter& Add(double number);
  /// Quoted where it must be; with a text mark where spreadsheets would take it for a formula, see csv_text_mark.h; in
  /// valid UTF-8.
  CsvWriter& Add(std::string_view text);

  /// The table as text. Throws std::logic_error when the last row is not full.
  const std::string& text() const;

 private:
  void AddField(std::string_view field);

  std::size_t columns_;
  std::size_t fields_in_row_ = 0;
  std::string text_;
};

}  // namespace fourpost
