#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/csv_dialect.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// What stands above the data: names of the columns, or names and units. Units stand below the names, or behind them
/// where the next line has numbers: "Force [kN]".
enum class CsvHeader { kNames, kNamesAndUnits };

/// A table as it stands in its text file; every row has one field per column.
class CsvTable {
 public:
  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  /// One per column, as written, empty where it has none; none without CsvHeader::kNamesAndUnits.
  const std::vector<std::string>& units() const { return units_; }
  /// False where the file has none, and columns are called column1, column2 and so on.
  bool has_names() const { return has_names_; }
  /// Lines of the names and of the units.
  int names_line() const { return names_line_; }
  int units_line() const { return units_line_; }
  /// Whether each second column is the times of the one behind it: Time, a, Time, b.
  bool has_times_per_channel() const { return has_times_per_channel_; }
  const CsvDialect& dialect() const { return dialect_; }
  std::size_t columns() const { return names_.size(); }
  std::size_t rows() const { return lines_.size(); }
  /// 1-based line of the file at which a row begins.
  int line(std::size_t row) const { return lines_[row]; }

  std::optional<std::size_t> FindColumn(std::string_view name) const;

  /// A field without its quotes and without blanks around it.
  const std::string& Text(std::size_t row, std::size_t column) const { return fields_[row * columns() + column]; }
  /// A finite number with the table's decimal sign; nothing for other text.
  std::optional<double> ToNumber(std::string_view text) const;
  /// NaN for an empty field; nothing when the field is anything but a finite number.
  std::optional<double> Number(std::size_t row, std::size_t column) const;
  /// The whole column, NaN for empty fields. Reports every field that is not a finite number (NaN there, too).
  std::vector<double> Numbers(std::size_t column, Diagnostics& diagnostics) const;

 private:
  friend class CsvParser;

  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  bool has_names_ = true;
  int names_line_ = 1;
  int units_line_ = 0;
  bool has_times_per_channel_ = false;
  CsvDialect dialect_;
  std::vector<int> lines_;
  /// Row by row.
  std::vector<std::string> fields_;
};

/// Reads a table in text (RFC 4180) of the dialect that it shows: quoted fields, LF or CRLF, with or without byte order
/// mark; blank lines, a first line such as "sep=;", other lines above the names, columns without a name and content,
/// separators behind the last field and a '#' before the first name do not count. Names of times may repeat where each
/// channel has its own before it. Warns where a table begins with a row and has no names, and where one with units ends
/// within a row, which is left out. Reports all of: an unreadable or empty file, JSON, a column without or with another
/// one's name, rows of another length than the header, faulty quotes. Nothing when there was one.
std::optional<CsvTable> ReadCsv(const std::filesystem::path& file, Diagnostics& diagnostics,
                                CsvHeader header = CsvHeader::kNames);

/// The same for text that is in memory already; `file` is its name in messages.
std::optional<CsvTable> ParseCsv(std::string_view text, std::string file, Diagnostics& diagnostics,
                                 CsvHeader header = CsvHeader::kNames);

}  // namespace fourpost
