#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analysis/csv.h"

namespace fourpost {

/// The recordings of a history.csv or bench.csv, which has a column `recording`, and numbers in all others:
/// [{"recording", "columns": [{"name", "unit", "values"}], "rows", "shown_rows"}]. A column in which a recording has
/// nothing is left out. Of more than 50000 rows, of each stretch those stay that hold the least or the greatest value
/// of a column. Throws FaultyInput.
nlohmann::ordered_json HistoriesJson(const std::string& text, const std::string& file,
                                     CsvHeader header = CsvHeader::kNamesAndUnits);

}  // namespace fourpost
