#include "identify/report/history_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/csv.h"
#include "identify/report/picture_number.h"
#include "identify/report/run_result.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/// Ten times what a screen is wide.
constexpr std::size_t kMostRows = 20000;

/// Rows that tell the picture: the extremes of each stretch of the column.
std::vector<std::size_t> RowsToShow(const std::vector<double>& column) {
  std::vector<std::size_t> rows;
  const std::size_t stretch = column.size() <= kMostRows ? 1 : (2 * column.size() + kMostRows - 1) / kMostRows;
  for (std::size_t first = 0; first < column.size(); first += stretch) {
    const auto begin = column.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = column.begin() + static_cast<std::ptrdiff_t>(std::min(first + stretch, column.size()));
    const auto [low, high] = std::minmax_element(begin, end);
    const std::size_t a = static_cast<std::size_t>(std::min(low, high) - column.begin());
    const std::size_t b = static_cast<std::size_t>(std::max(low, high) - column.begin());
    rows.push_back(a);
    if (b != a) rows.push_back(b);
  }
  return rows;
}

/// The first column after the time.
std::size_t LeadingColumn(const CsvTable& table) { return table.columns() > 1 ? 1 : 0; }

void AddColumns(const CsvTable& table, OrderedJson& recording) {
  Diagnostics faults;
  const std::vector<std::size_t> rows = RowsToShow(table.Numbers(LeadingColumn(table), faults));
  OrderedJson columns = OrderedJson::array();
  for (std::size_t c = 0; c < table.columns(); ++c) {
    OrderedJson values = OrderedJson::array();
    for (const std::size_t row : rows) values.push_back(PictureNumber(table.Number(row, c).value_or(NAN)));
    columns.push_back({{"name", table.names()[c]}, {"values", std::move(values)}});
  }
  recording["columns"] = std::move(columns);
  recording["rows"] = table.rows();
  recording["shown_rows"] = rows.size();
}

}  // namespace

OrderedJson HistoriesJson(const Json& result, const RunContents& run, const std::string& key) {
  OrderedJson list = OrderedJson::array();
  for (const Json& told : ListAt(result, key)) {
    const auto file = run.files.find(TextAt(told, "file"));
    if (file == run.files.end()) continue;
    Diagnostics faults;
    const std::optional<CsvTable> table = ParseCsv(file->second, file->first, faults);
    if (!table || table->rows() == 0) continue;
    OrderedJson recording = told;
    AddColumns(*table, recording);
    list.push_back(std::move(recording));
  }
  return list;
}

}  // namespace fourpost
