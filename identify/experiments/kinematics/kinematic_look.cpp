#include "identify/experiments/kinematics/kinematic_look.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/text/text_table.h"
#include "identify/experiments/kinematics/kinematic_column.h"

namespace fourpost {
namespace {

/// What a column holds: numbers in a range, or words.
struct ColumnRange {
  KinematicColumn column;
  std::size_t count = 0;
  double lower = 0;
  double upper = 0;
  std::set<std::string> words;
};

ColumnRange RangeOf(const RecordedTable& table, const KinematicColumn& column) {
  ColumnRange range{.column = column};
  for (std::size_t row = 0; row < table.rows(column.index); ++row) {
    if (column.is_text) {
      range.words.insert(table.Text(row, column.index));
      continue;
    }
    const double number = table.Number(row, column.index).value_or(NAN);
    if (std::isnan(number)) continue;
    range.lower = range.count == 0 ? number : std::min(range.lower, number);
    range.upper = range.count == 0 ? number : std::max(range.upper, number);
    ++range.count;
  }
  return range;
}

std::string Listed(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::optional<RecordingLook> LookAt(const std::filesystem::path& file, const RecordedTable& table, Diagnostics&) {
  TextTable text({"column", "unit", "numbers", "least", "greatest", "quantity"});
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  std::string words;
  for (const KinematicColumn& column : KinematicColumns(table)) {
    const ColumnRange range = RangeOf(table, column);
    const std::string& name = table.names()[column.index];
    if (column.is_text) {
      words += name + ": " + Listed(range.words) + '\n';
      columns.push_back({{"name", name}, {"values", range.words}});
      continue;
    }
    const std::optional<QuantityName> quantity = ParseQuantityName(column.name);
    text.Add({name, column.unit, std::to_string(range.count), Rounded(range.lower, 4), Rounded(range.upper, 4),
              quantity ? quantity->quantity : ""});
    columns.push_back({{"name", name},
                       {"unit", column.unit},
                       {"numbers", range.count},
                       {"least", range.lower},
                       {"greatest", range.upper}});
  }
  return RecordingLook{file.string() + ": kinematics and compliance, " + std::to_string(table.rows(0)) + " rows\n" +
                           words + text.Format() + "to fit it, name it under `kinematics` of a study\n",
                       {{"kind", "kinematics"}, {"columns", columns}}};
}

}  // namespace

const RecordingViewer kKinematicViewer{.takes = &IsKinematicTable, .look = &LookAt};

}  // namespace fourpost
