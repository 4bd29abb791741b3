#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/found.h"

namespace fourpost {

/// One line of a table in text; more than one when a quoted field holds a line break.
struct CsvRecord {
  /// 1-based line at which it begins.
  int line = 0;
  std::vector<std::string> fields;
  /// What is wrong with its quotes.
  Found fault;
};

/// Splits text (RFC 4180, with any separator) into records. Blanks around a field and a
/// text mark in front of it do not belong to it.
class CsvScanner {
 public:
  /// The text must outlive the scanner; `line`: the number of its first.
  explicit CsvScanner(std::string_view text, char separator = ',', int line = 1);

  /// Overwrites `record` with the next line that is not blank; false at the end.
  bool Next(CsvRecord& record);
  /// Byte of the text behind the last record.
  std::size_t at() const { return size_ - rest_.size(); }

 private:
  void ReadRecord(CsvRecord& record);
  std::string ReadField(CsvRecord& record);
  std::string ReadQuoted(CsvRecord& record);
  std::string_view Take(std::string_view until);

  std::size_t size_;
  std::string_view rest_;
  /// End of a field.
  std::string ends_;
  std::string_view blanks_;
  int line_;
};

}  // namespace fourpost
