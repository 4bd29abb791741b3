#include "identify/experiments/run_history.h"

#include <algorithm>
#include <cmath>

#include "analysis/report/packed_values.h"
#include "analysis/report/picture_number.h"
#include "identify/experiments/findings.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

bool HasNumbers(const TableColumn& column) {
  return std::any_of(column.values.begin(), column.values.end(), [](double value) { return std::isfinite(value); });
}

/// Of rows [first, last).
TimeTable TableOf(const CsvTable& table, std::size_t names, std::size_t first, std::size_t last) {
  TimeTable history{.recording = table.Text(first, names), .rows = last - first};
  for (std::size_t c = 0; c < table.columns(); ++c) {
    if (c == names) continue;
    TableColumn column{.name = table.names()[c], .unit = table.units().empty() ? "" : table.units()[c]};
    for (std::size_t row = first; row < last; ++row) column.values.push_back(table.Number(row, c).value_or(NAN));
    if (HasNumbers(column)) history.columns.push_back(std::move(column));
  }
  return history;
}

std::vector<double> Of(const TableColumn& column, const std::set<std::size_t>& rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) values.push_back(column.values[row]);
  return values;
}

}  // namespace

const TableColumn* TimeTable::Find(const std::string& name) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const TableColumn& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::vector<TimeTable> ReadHistories(const std::string& text, const std::string& file, CsvHeader header) {
  Diagnostics faults;
  const std::optional<CsvTable> table = ParseCsv(text, file, faults, header);
  // A result that ends within a row is damaged, whatever a recording may do.
  if (!table || !faults.items().empty()) throw FaultyInput(faults);
  const std::optional<std::size_t> names = table->FindColumn("recording");
  if (!names) Refuse(kFitColumnMissing, {file, 1}, {"recording"});
  std::vector<TimeTable> histories;
  // Rows of a recording stand together.
  for (std::size_t first = 0; first < table->rows();) {
    std::size_t last = first + 1;
    while (last < table->rows() && table->Text(last, *names) == table->Text(first, *names)) ++last;
    histories.push_back(TableOf(*table, *names, first, last));
    first = last;
  }
  return histories;
}

std::set<std::size_t> RowsToShow(const std::vector<const TableColumn*>& columns, std::size_t rows, std::size_t most) {
  std::set<std::size_t> shown;
  // Of each stretch its first row, and two of each column.
  const std::size_t stretches = std::max<std::size_t>(most / (2 * columns.size() + 1), 1);
  const std::size_t stretch = rows <= most ? 1 : (rows + stretches - 1) / stretches;
  for (std::size_t first = 0; first < rows; first += stretch) {
    shown.insert(first);
    for (const TableColumn* column : columns) {
      if (stretch == 1) break;
      const auto begin = column->values.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = column->values.begin() + static_cast<std::ptrdiff_t>(std::min(first + stretch, rows));
      const auto [low, high] = std::minmax_element(begin, end);
      shown.insert(static_cast<std::size_t>(low - column->values.begin()));
      shown.insert(static_cast<std::size_t>(high - column->values.begin()));
    }
  }
  return shown;
}

OrderedJson ShownValues(const TableColumn& column, const std::set<std::size_t>& rows) {
  OrderedJson values = OrderedJson::array();
  for (const std::size_t row : rows) values.push_back(PictureNumber(column.values[row]));
  return values;
}

OrderedJson RecordingJson(const TimeTable& history, std::size_t most) {
  std::vector<const TableColumn*> columns;
  for (const TableColumn& column : history.columns) columns.push_back(&column);
  const std::set<std::size_t> rows = RowsToShow(columns, history.rows, most);
  OrderedJson list = OrderedJson::array();
  for (const TableColumn& column : history.columns) {
    OrderedJson json = {{"name", column.name}, {"unit", column.unit}};
    json.update(PackedValues(Of(column, rows)));
    list.push_back(std::move(json));
  }
  return {{"recording", history.recording},
          {"columns", std::move(list)},
          {"rows", history.rows},
          {"shown_rows", rows.size()}};
}

OrderedJson HistoriesJson(const std::string& text, const std::string& file, CsvHeader header, std::size_t most) {
  OrderedJson list = OrderedJson::array();
  for (const TimeTable& history : ReadHistories(text, file, header)) list.push_back(RecordingJson(history, most));
  return list;
}

}  // namespace fourpost
