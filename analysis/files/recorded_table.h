#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/files/csv.h"
#include "analysis/files/mat_file.h"
#include "analysis/files/recording_columns.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Columns of a recording as they stand in its file: text as CsvTable has it, a MAT file, or a recording of a
/// measurement system. A column of time stamps in text is in seconds after its first.
class RecordedTable {
 public:
  explicit RecordedTable(CsvTable csv);
  RecordedTable(std::string file, std::vector<MatVector> vectors);
  RecordedTable(std::string file, RecordingColumns columns);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  std::optional<std::size_t> FindColumn(std::string_view name) const;
  /// Of a MAT file; text files have numbers or texts in any field, and recordings numbers only.
  bool HoldsText(std::size_t column) const;
  /// Reports every required column that is missing, every column that is neither required nor optional, and every one
  /// of another length than the first; false then.
  bool CheckColumns(std::span<const std::string_view> required, std::span<const std::string_view> optional,
                    Diagnostics& diagnostics) const;
  /// As written; empty where the file has none.
  const std::string& unit(std::size_t column) const { return units_[column]; }
  /// Of a recording of a measurement system, else null.
  const RecordingColumns* recording() const { return recording_ ? &*recording_ : nullptr; }
  /// False of text that names no columns; these are called column1 and so on.
  bool has_names() const { return !csv_ || csv_->has_names(); }
  /// Lines of names, units and rows; 0 of files without lines.
  int names_line() const { return csv_ ? csv_->names_line() : 0; }
  int units_line() const { return csv_ ? csv_->units_line() : 0; }
  int line(std::size_t row) const { return csv_ ? csv_->line(row) : 0; }
  /// "line 7", or "row 6" of a file without lines.
  std::string RowInWords(std::size_t row) const;
  /// Adds a finding about a row; its message begins with the row where the file has no lines.
  void Report(const Finding& kind, std::size_t row, const std::vector<std::string>& words,
              Diagnostics& diagnostics) const;

  std::size_t rows(std::size_t column) const;
  /// NaN where there is none; nothing for what is no number. Throws FaultyInput where a recording of a measurement
  /// system is faulty behind its header; it is read column by column.
  std::optional<double> Number(std::size_t row, std::size_t column) const;
  /// As written.
  std::string Text(std::size_t row, std::size_t column) const;
  /// Where a user writes a unit such as `such` of a column.
  std::string WhereUnitsStand(const std::string& name, const std::string& such) const;

 private:
  void NumberColumns();
  void ReadTimeStamps();

  std::string file_;
  std::vector<std::string> names_;
  /// Place of each name.
  std::unordered_map<std::string, std::size_t> columns_;
  std::vector<std::string> units_;
  /// One of these is filled.
  std::optional<CsvTable> csv_;
  std::vector<MatVector> vectors_;
  std::optional<RecordingColumns> recording_;
  /// Of columns of text that hold some, by column; nothing for a field that is none.
  std::map<std::size_t, std::vector<std::optional<double>>> stamps_s_;
};

/// By the content of the file; a MAT file of version 4, which shows nothing of it, is named .mat. `header` is that of
/// text files. Adds every fault of the file to `diagnostics`; nothing when there was one.
std::optional<RecordedTable> ReadRecordedTable(const std::filesystem::path& file, Diagnostics& diagnostics,
                                               CsvHeader header = CsvHeader::kNamesAndUnits);

}  // namespace fourpost
