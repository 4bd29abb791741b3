#include "analysis/files/csv.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <unordered_set>
#include <utility>

#include "analysis/files/csv_fault.h"
#include "analysis/files/csv_scanner.h"
#include "analysis/files/csv_start.h"
#include "analysis/files/findings.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/text_file.h"
#include "analysis/files/time_recording.h"
#include "analysis/text/number.h"
#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

std::string Count(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace

/// Makes a table of records, and reports all that are faulty.
class CsvParser {
 public:
  CsvParser(std::string_view text, std::string file, Diagnostics& diagnostics)
      : CsvParser(text, StartBelowLines(text).value_or(CsvStart()), std::move(file), diagnostics) {}

  std::optional<CsvTable> Parse(CsvHeader header) {
    if (text_fault_) Fault(0, text_fault_);
    else ReadNames();
    if (good_ && header == CsvHeader::kNamesAndUnits && table_.has_names_) ReadUnits();
    if (good_) CheckNames();
    // Without a header no row can be right.
    if (!good_) return std::nullopt;
    while (scanner_.Next(record_)) {
      // Of what a recorder wrote; a result that is damaged is none.
      if (header == CsvHeader::kNamesAndUnits && IsCutOff()) ReportCutOff();
      else AddRow();
    }
    if (good_ && table_.rows() == 0) Fault(0, {&kCsvNoRows});
    if (good_) DropEmptyColumns();
    if (!good_) return std::nullopt;
    return std::move(table_);
  }

 private:
  CsvParser(std::string_view text, const CsvStart& start, std::string file, Diagnostics& diagnostics)
      : dialect_(DialectOf(text.substr(start.at))),
        scanner_(text.substr(start.at), dialect_.separator, start.line),
        size_(text.size() - start.at),
        ends_with_line_(text.ends_with('\n')),
        diagnostics_(diagnostics) {
    table_.file_ = std::move(file);
    table_.dialect_ = dialect_;
    text_fault_ = FaultOfText(text);
  }

  void Fault(int line, const Found& found) {
    diagnostics_.Report(*found.kind, {table_.file_, line}, found.words);
    good_ = false;
  }

  void ReadNames() {
    // Excel's note of the separator.
    bool found = scanner_.Next(record_);
    if (found && record_.fields[0].starts_with("sep=")) found = scanner_.Next(record_);
    if (!found) return Fault(0, {&kCsvEmpty});
    if (record_.fault) return Fault(record_.line, record_.fault);
    if (IsRowWithoutNames(record_, scanner_)) return NameColumns();
    table_.names_ = record_.fields;
    for (std::string& name : table_.names_) name = Utf8OfEither(name);
    table_.names_line_ = record_.line;
    names_are_marked_ = TakeMark(table_.names_.front());
    const bool ends_with_separator = table_.columns() > 1 && table_.names_.back().empty();
    while (table_.columns() > 1 && table_.names_.back().empty()) table_.names_.pop_back();
    ends_with_comment_ = table_.columns() > 2 && IsComment(table_.names_.back());
    if (ends_with_comment_) return;
    const Found fault = FaultOfNames(scanner_, table_.columns(), ends_with_separator, dialect_.separator);
    if (fault) Fault(table_.names_line_, fault);
  }

  /// By their numbers. The record is the first row.
  void NameColumns() {
    while (record_.fields.back().empty()) record_.fields.pop_back();
    for (std::size_t column = 1; column <= record_.fields.size(); ++column)
      table_.names_.push_back("column" + std::to_string(column));
    table_.units_.resize(table_.columns());
    table_.has_names_ = false;
    table_.names_line_ = table_.units_line_ = record_.line;
    diagnostics_.Report(kCsvWithoutNames, {table_.file_, record_.line}, {table_.names_.back()});
    Keep();
  }

  /// Lines of names and units may be marked as comments. Whether it was.
  static bool TakeMark(std::string& field) {
    if (field.size() < 2 || (field[0] != '#' && field[0] != '%')) return false;
    const std::size_t first = field.find_first_not_of("#% ");
    if (first == std::string::npos) return false;
    field.erase(0, first);
    return true;
  }

  static bool IsComment(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name.starts_with("comment") || name.starts_with("remark");
  }

  /// "Time", "a", "Time", "b"
  bool HasTimesPerChannel() const {
    const std::vector<std::string>& names = table_.names_;
    if (names.size() < 4 || names.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < names.size(); i += 2)
      if (names[i] != names[0] || names[i + 1] == names[0]) return false;
    const std::vector<std::string>& usual = kTimeColumn.names;
    return names[0] == "X_Value" || std::find(usual.begin(), usual.end(), names[0]) != usual.end();
  }

  void CheckNames() {
    table_.has_times_per_channel_ = HasTimesPerChannel();
    std::unordered_set<std::string_view> earlier;
    for (std::size_t i = 0; i < table_.columns(); ++i) {
      const std::string& name = table_.names_[i];
      const bool may_repeat = name.empty() || (table_.has_times_per_channel_ && i % 2 == 0);
      if (!may_repeat && !earlier.insert(name).second)
        Fault(table_.names_line_, {&kCsvColumnTwice, {std::to_string(i + 1), name}});
    }
  }

  /// Those without a name, which may hold nothing.
  void DropEmptyColumns() {
    std::vector<bool> keep(table_.columns(), true);
    for (std::size_t column = 0; column < table_.columns(); ++column) {
      if (!table_.names_[column].empty()) continue;
      keep[column] = false;
      for (std::size_t row = 0; row < table_.rows() && !keep[column]; ++row)
        keep[column] = !table_.Text(row, column).empty();
      if (keep[column]) Fault(table_.names_line_, {&kCsvColumnNameless, {std::to_string(column + 1)}});
    }
    if (std::find(keep.begin(), keep.end(), false) == keep.end()) return;
    const auto without = [&](std::vector<std::string>& fields) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < fields.size(); ++i)
        if (keep[i % keep.size()]) {
          if (kept != i) fields[kept] = std::move(fields[i]);
          ++kept;
        }
      fields.resize(kept);
    };
    without(table_.fields_);
    without(table_.units_);
    without(table_.names_);
  }

  void ReadUnits() {
    if (!scanner_.Next(record_)) return Fault(0, {&kCsvNoRows});
    if (!IsRowGood()) return;
    table_.units_line_ = record_.line;
    std::vector<std::string> fields = record_.fields;
    // "%" may be a unit.
    if (names_are_marked_) TakeMark(fields.front());
    for (std::string& field : fields) field = Utf8OfEither(WithoutBrackets(field));
    if (IsRowOfUnits(fields)) {
      table_.units_ = std::move(fields);
      return;
    }
    TakeUnitsFromNames();
    Keep();
  }

  /// Has no numbers, or as many units; "1" is both.
  bool IsRowOfUnits(const std::vector<std::string>& fields) const {
    const auto is_number = [this](const std::string& field) { return table_.ToNumber(field).has_value(); };
    const auto is_unit = [&](const std::string& field) { return ParseRecordedUnit(field) && !is_number(field); };
    const auto numbers = std::count_if(fields.begin(), fields.end(), is_number);
    const auto units = std::count_if(fields.begin(), fields.end(), is_unit);
    return numbers == 0 || (units > 0 && units >= numbers);
  }

  void TakeUnitsFromNames() {
    table_.units_line_ = table_.names_line_;
    for (std::string& name : table_.names_) {
      NamedColumn column = SplitColumnName(name);
      name = std::move(column.name);
      table_.units_.push_back(std::move(column.unit));
    }
  }

  void AddRow() {
    if (IsRowGood()) Keep();
  }

  /// The last line of a file whose writing ended within a row.
  bool IsCutOff() const {
    return !ends_with_line_ && scanner_.at() == size_ && table_.rows() > 0 && !record_.fault &&
           record_.fields.size() + (ends_with_comment_ ? 1 : 0) < table_.columns();
  }

  void ReportCutOff() {
    diagnostics_.Report(kCsvLastRowCut, {table_.file_, record_.line},
                        {Count(record_.fields.size(), "field"), std::to_string(table_.columns())});
  }

  void Keep() {
    table_.lines_.push_back(record_.line);
    std::move(record_.fields.begin(), record_.fields.end(), std::back_inserter(table_.fields_));
  }

  bool IsRowGood() {
    while (record_.fields.size() > table_.columns() && record_.fields.back().empty()) record_.fields.pop_back();
    if (ends_with_comment_ && record_.fields.size() + 1 == table_.columns()) record_.fields.emplace_back();
    const std::size_t fields = record_.fields.size();
    const std::size_t columns = table_.columns();
    if (record_.fault) Fault(record_.line, record_.fault);
    else if (fields != columns)
      Fault(record_.line, {&kCsvRowLength, {Count(fields, "field"), std::to_string(columns)}});
    return !record_.fault && fields == columns;
  }

  CsvDialect dialect_;
  CsvScanner scanner_;
  std::size_t size_;
  bool ends_with_line_;
  Diagnostics& diagnostics_;
  CsvTable table_;
  CsvRecord record_;
  Found text_fault_;
  /// Rows need not have the last field.
  bool ends_with_comment_ = false;
  bool names_are_marked_ = false;
  bool good_ = true;
};

std::optional<std::size_t> CsvTable::FindColumn(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

std::optional<double> CsvTable::ToNumber(std::string_view text) const {
  if (dialect_.decimal == '.') return ParseNumber(text);
  if (text.find('.') != std::string_view::npos) return std::nullopt;
  std::string number(text);
  if (const std::size_t at = number.find(','); at != std::string::npos) number[at] = '.';
  return ParseNumber(number);
}

std::optional<double> CsvTable::Number(std::size_t row, std::size_t column) const {
  const std::string& text = Text(row, column);
  return text.empty() ? std::numeric_limits<double>::quiet_NaN() : ToNumber(text);
}

std::vector<double> CsvTable::Numbers(std::size_t column, Diagnostics& diagnostics) const {
  std::vector<double> numbers;
  numbers.reserve(rows());
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::optional<double> number = Number(row, column);
    if (!number) diagnostics.Report(kCsvNotANumber, {file_, line(row)}, {names_[column], Text(row, column)});
    numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return numbers;
}

std::optional<CsvTable> ParseCsv(std::string_view text, std::string file, Diagnostics& diagnostics, CsvHeader header) {
  return CsvParser(text, std::move(file), diagnostics).Parse(header);
}

std::optional<CsvTable> ReadCsv(const std::filesystem::path& file, Diagnostics& diagnostics, CsvHeader header) {
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return std::nullopt;
  return ParseCsv(*text, file.string(), diagnostics, header);
}

}  // namespace fourpost
