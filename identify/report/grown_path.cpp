#include "identify/report/grown_path.h"

#include <cmath>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using html::Escaped;
using html::NumberCell;
using html::TextCell;

Json GrowthOf(const Json& result) {
  Json growth = result.value("growth", Json());
  return growth.is_object() ? growth : Json::object();
}

std::string WhetherKept(const Json& step) {
  if (step.value("kept", false) != true) return "no: " + TextAt(step, "reason");
  const double by = NumberAt(step, "taken_back_by");
  return std::isfinite(by) ? "taken back in step " + ShownDecimals(by, 0) : "yes";
}

std::vector<html::Cell> Row(const Json& step) {
  const std::string what = TextAt(step, "what");
  return {NumberCell(ShownDecimals(NumberAt(step, "step"), 0)),
          TextCell(what.empty() ? "the study as it stands"
                                : (TextAt(step, "change") == "taken back" ? "without " : "with ") + what),
          NumberCell(ShownNumber(NumberAt(step, "misfit"), 3)),
          NumberCell(ShownNumber(NumberAt(step, "criterion_change"), 3)),
          NumberCell(ShownNumber(NumberAt(step, "validation_percent"), 3)),
          TextCell(WhetherKept(step))};
}

}  // namespace

std::string InterruptedGrowth(const Json& result) {
  const Json growth = GrowthOf(result);
  if (growth.value("interrupted", false) != true) return "";
  const std::vector<Json> added = ListAt(growth, "added");
  const std::string last =
      added.empty() || !added.back().is_string() ? "" : " (" + Escaped(added.back().get<std::string>()) + ")";
  const std::string not_done = TextAt(growth, "not_done");
  return "<strong>Growth was interrupted after step " + std::to_string(added.size()) + last + ".</strong> " +
         (not_done.empty() ? "" : "Not done: " + Escaped(not_done) + ". ");
}

std::string HowItGrew(const Json& result) {
  std::vector<std::vector<html::Cell>> rows;
  for (const Json& step : ListAt(GrowthOf(result), "steps")) rows.push_back(Row(step));
  if (rows.empty()) return "";
  return html::Table({"step", "model", "misfit", "change of BIC", "validation rms error, %", "kept"}, rows) +
         html::Element("p", "", "It ended: " + Escaped(TextAt(GrowthOf(result), "end")) + ".");
}

}  // namespace fourpost
