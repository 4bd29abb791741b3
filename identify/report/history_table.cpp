#include "identify/report/history_table.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "identify/report/picture_number.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// So that each recording takes some megabytes at the most, and a zoom still shows each cycle.
constexpr std::size_t kMostRows = 50000;

struct Column {
  std::string name;
  std::string unit;
  std::vector<double> values;

  bool HasNumbers() const {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  }
};

struct Recording {
  std::string name;
  /// In the table, one past the last.
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Rows of a recording stand together.
std::vector<Recording> RecordingsOf(const CsvTable& table, std::size_t column) {
  std::vector<Recording> recordings;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.Text(row, column);
    if (recordings.empty() || recordings.back().name != name) recordings.push_back({.name = name, .first = row});
    recordings.back().last = row + 1;
  }
  return recordings;
}

std::vector<Column> ColumnsOf(const CsvTable& table, std::size_t names, const Recording& recording) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < table.columns(); ++c) {
    if (c == names) continue;
    Column column{.name = table.names()[c], .unit = table.units().empty() ? "" : table.units()[c]};
    for (std::size_t row = recording.first; row < recording.last; ++row)
      column.values.push_back(table.Number(row, c).value_or(NAN));
    if (column.HasNumbers()) columns.push_back(std::move(column));
  }
  return columns;
}

/// The rows that tell the picture.
std::set<std::size_t> RowsToShow(const std::vector<Column>& columns, std::size_t rows) {
  std::set<std::size_t> shown;
  const std::size_t stretch = rows <= kMostRows ? 1 : 2 * columns.size() * rows / kMostRows + 1;
  for (std::size_t first = 0; first < rows; first += stretch) {
    shown.insert(first);
    for (const Column& column : columns) {
      if (stretch == 1) break;
      const auto begin = column.values.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = column.values.begin() + static_cast<std::ptrdiff_t>(std::min(first + stretch, rows));
      const auto [low, high] = std::minmax_element(begin, end);
      shown.insert(static_cast<std::size_t>(low - column.values.begin()));
      shown.insert(static_cast<std::size_t>(high - column.values.begin()));
    }
  }
  return shown;
}

OrderedJson RecordingJson(const CsvTable& table, std::size_t names, const Recording& recording) {
  const std::vector<Column> columns = ColumnsOf(table, names, recording);
  const std::set<std::size_t> rows = RowsToShow(columns, recording.last - recording.first);
  OrderedJson list = OrderedJson::array();
  for (const Column& column : columns) {
    OrderedJson values = OrderedJson::array();
    for (const std::size_t row : rows) values.push_back(PictureNumber(column.values[row]));
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"values", std::move(values)}});
  }
  return {{"recording", recording.name},
          {"columns", std::move(list)},
          {"rows", recording.last - recording.first},
          {"shown_rows", rows.size()}};
}

}  // namespace

OrderedJson HistoriesJson(const std::string& text, const std::string& file, CsvHeader header) {
  Diagnostics faults;
  const std::optional<CsvTable> table = ParseCsv(text, file, faults, header);
  if (!table) throw FaultyInput(faults);
  const std::optional<std::size_t> names = table->FindColumn("recording");
  if (!names) {
    faults.Error(file, 1, "has no column 'recording'; fit again");
    throw FaultyInput(faults);
  }
  OrderedJson list = OrderedJson::array();
  for (const Recording& recording : RecordingsOf(*table, *names))
    list.push_back(RecordingJson(*table, *names, recording));
  return list;
}

}  // namespace fourpost
