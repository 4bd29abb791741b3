#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "identify/report/run_contents.h"

namespace fourpost {

/// The recordings that result.json lists under `key` ("histories" or "bench"), each with the columns of the CSV file
/// that it names: [{..., "columns": [{"name", "values"}], "rows", "shown_rows"}]. Of more than 20000 rows, of each
/// stretch of rows those with the least and the greatest value of its first measured column stay. A file that is not
/// there or cannot be read is left out. Its names and shape: analysis/report/README.md.
nlohmann::ordered_json HistoriesJson(const nlohmann::json& result, const RunContents& run, const std::string& key);

}  // namespace fourpost
