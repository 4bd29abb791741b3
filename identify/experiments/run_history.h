#pragma once

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/csv.h"

namespace fourpost {

struct TableColumn {
  std::string name;
  /// Empty where the file has none.
  std::string unit;
  /// NaN where there is nothing.
  std::vector<double> values;
};

/// A recording of a history.csv or bench.csv. A column in which it has nothing is left out.
struct TimeTable {
  std::string recording;
  std::vector<TableColumn> columns;
  std::size_t rows = 0;

  /// Null where there is none.
  const TableColumn* Find(const std::string& name) const;
};

/// Reads such a file, which has a column `recording`, and numbers in all others. Throws FaultyInput.
std::vector<TimeTable> ReadHistories(const std::string& text, const std::string& file,
                                     CsvHeader header = CsvHeader::kNamesAndUnits);

/// All of `rows`; of more than `most`, the first of each stretch and those that hold its least and greatest value of
/// each column, `most` together or a few less; of one stretch alone where there are about as many columns.
std::set<std::size_t> RowsToShow(const std::vector<const TableColumn*>& columns, std::size_t rows, std::size_t most);

/// Values of these rows.
nlohmann::ordered_json ShownValues(const TableColumn& column, const std::set<std::size_t>& rows);

/// All of what rigs record in minutes: some twenty channels of it take 10 MB of a page.
inline constexpr std::size_t kMostHistoryRows = 300000;

/// {"recording", "columns": [{"name", "unit", of PackedValues()}], "rows", "shown_rows"}, up to `most` rows.
nlohmann::ordered_json RecordingJson(const TimeTable& history, std::size_t most = kMostHistoryRows);

/// The recordings of a file as a list of these. Throws FaultyInput.
nlohmann::ordered_json HistoriesJson(const std::string& text, const std::string& file,
                                     CsvHeader header = CsvHeader::kNamesAndUnits, std::size_t most = kMostHistoryRows);

}  // namespace fourpost
