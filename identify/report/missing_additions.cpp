#include "identify/report/missing_additions.h"

#include <cmath>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using html::Code;

/// What the fit found worth adding to the vehicle; empty of runs that did not look.
std::vector<Json> MissingOf(const Json& result) { return ListAt(result.value("missing", Json()), "suggestions"); }

/// "dry friction beside damper 'front' (149 N)"
std::string AdditionText(const Json& missing) {
  const std::string expected = TextAt(missing, "expected");
  return html::Escaped(TextAt(missing, "text") + (expected.empty() ? "" : " (" + expected + ")"));
}

/// "<code>k</code> +11 %, ..."
std::string MovesOf(const Json& one) {
  std::string moves;
  for (const Json& moved : ListAt(one, "moves"))
    moves += (moves.empty() ? "" : ", ") + Code(TextAt(moved, "name")) + ' ' +
             (NumberAt(moved, "percent") > 0 ? "+" : "") + ShownNumber(NumberAt(moved, "percent"), 2) + " %";
  return moves;
}

/// What additions would do together.
std::string TogetherOf(const Json& result) {
  const Json together =
      result.value("missing", Json()).is_object() ? result["missing"].value("together", Json()) : Json();
  std::string words;
  for (const Json& one : ListAt(together, "additions"))
    if (one.is_string()) words += (words.empty() ? "" : "; ") + html::Escaped(one.get<std::string>());
  const std::string moves = MovesOf(together);
  if (words.empty() || moves.empty()) return "";
  return html::Element("p", "",
                       "Together (" + words + ") they would move the parameters, and the intervals reach there: " +
                           moves + ". " + Code("fourpost fit --grow") + " adds step by step what lowers BIC.");
}

}  // namespace

std::string MostLikelyMissing(const Json& result) {
  const std::vector<Json> missing = MissingOf(result);
  if (const std::string correction = LikeliestCorrection(result); !correction.empty())
    return " Most probably a channel is off: " + correction + '.';
  return missing.empty() ? "" : " The model most probably lacks " + AdditionText(missing.front()) + '.';
}

std::string LikeliestCorrection(const Json& result) {
  const std::vector<Json> missing = MissingOf(result);
  if (missing.empty()) return "";
  const std::string mechanism = TextAt(missing.front(), "mechanism");
  return mechanism == "delay" || mechanism == "scale" ? AdditionText(missing.front()) : "";
}

std::string WhatIsMissing(const Json& result, bool is_misfit_large) {
  std::string items;
  for (const Json& one : MissingOf(result)) {
    const std::string moves = MovesOf(one);
    items += html::Element("li", "",
                           AdditionText(one) + ": lowers the cost by " + ShownNumber(NumberAt(one, "fall_percent"), 2) +
                               " %" + (moves.empty() ? "" : "; moves " + moves));
  }
  const std::string together = TogetherOf(result);
  if (!items.empty()) return "Each alone, by its expected gain:" + html::Element("ul", "", items) + together;
  const double tried = NumberAt(result.value("missing", Json()), "tried");
  if (!together.empty() || !std::isfinite(tried) || !is_misfit_large) return together;
  return "Of " + ShownDecimals(tried, 0) + " additions to the model none explains the residuals.";
}

}  // namespace fourpost
