#include "identify/report/comparison_tables.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"

namespace fourpost {
namespace {

using html::Cell;
using html::NumberCell;
using html::TextCell;
using Json = nlohmann::json;
using Rows = std::vector<std::vector<Cell>>;

Cell NameCell(const std::string& name) { return {html::Element("code", "", html::Escaped(name)), ""}; }

/// A, B ... Z, 27, 28 ...
std::string Letter(std::size_t i) {
  return i < 26 ? std::string(1, static_cast<char>('A' + i)) : std::to_string(i + 1);
}

std::string OfWhich(const Json& starts) {
  const double refined = NumberAt(starts, "refined");
  return refined > 0 ? ShownDecimals(NumberAt(starts, "agreeing"), 0) + " of " + ShownDecimals(refined, 0) : "";
}

Cell EndCell(const Json& result) {
  std::string end = TextAt(result, "termination");
  std::replace(end.begin(), end.end(), '_', ' ');
  const bool explains = ListAt(result.value("verdict", Json()), "reasons").empty();
  if (!explains) end += ", does not explain the data";
  return {html::Escaped(end), end == "converged" ? "" : "remark calls"};
}

std::string MeanOf(const std::map<ChannelGroup, double>& errors) {
  double sum = 0;
  for (const auto& [group, error] : errors) sum += error;
  return errors.empty() ? "" : ShownNumber(sum / static_cast<double>(errors.size()), 3);
}

std::vector<Cell> RunRow(const ComparedRun& run, bool has_criteria) {
  const Json& result = run.result;
  std::vector<Cell> row = {{html::Element("b", "", html::Escaped(run.name)), "name"},
                           {html::Escaped(run.kind), "wrap"},
                           {html::Escaped(run.Recordings()), "wrap"},
                           EndCell(result),
                           NumberCell(std::to_string(run.parameters.size())),
                           TextCell(Letter(run.data)),
                           NumberCell(ShownDecimals(NumberAt(result, "residuals"), 0)),
                           NumberCell(ShownNumber(NumberAt(result, "cost"), 5)),
                           NumberCell(ShownNumber(NumberAt(result, "misfit"), 3)),
                           NumberCell(MeanOf(run.fitted)),
                           NumberCell(MeanOf(run.predicted))};
  if (has_criteria) {
    const Json criteria = result.value("criteria", Json());
    row.push_back(NumberCell(ShownNumber(NumberAt(criteria, "aicc"), 6)));
    row.push_back(NumberCell(ShownNumber(NumberAt(criteria, "bic"), 6)));
  }
  row.push_back(NumberCell(ShownDecimals(NumberAt(result.value("evaluations", Json()), "paid"), 0)));
  row.push_back(NumberCell(OfWhich(result.value("starts", Json()))));
  return row;
}

/// The parameter of a run; null where it has none of that name.
const ReportedParameter* Find(const ComparedRun& run, const std::string& name) {
  const auto found = std::find_if(run.parameters.begin(), run.parameters.end(),
                                  [&](const ReportedParameter& parameter) { return parameter.name == name; });
  return found == run.parameters.end() ? nullptr : &*found;
}

Cell ValueCell(const ReportedParameter* parameter, const std::string& unit) {
  if (parameter == nullptr) return {"", "n"};
  const int decimals = DecimalsFor(parameter->value, parameter->sd);
  std::string text = html::Element("b", "", ShownDecimals(parameter->value, decimals));
  if (parameter->unit != unit) text += ' ' + html::Escaped(ShownUnit(parameter->unit));
  if (std::isfinite(parameter->sd))
    text += "<br><small>" + ShownDecimals(parameter->lower_95, decimals) + " \u2026 " +
            ShownDecimals(parameter->upper_95, decimals) + "</small>";
  else if (std::isinf(parameter->sd)) text += "<br><small>not determined</small>";
  else if (parameter->state == ParameterState::kNoise) text += "<br><small>derivative is noise</small>";
  if (parameter->at_bound) text += "<br><small class=\"remark calls\">at its bound</small>";
  return {text, "n"};
}

std::vector<const ReportedParameter*> AllParameters(const std::vector<ComparedRun>& runs) {
  std::vector<const ReportedParameter*> all;
  for (const ComparedRun& run : runs)
    for (const ReportedParameter& parameter : run.parameters)
      if (std::none_of(all.begin(), all.end(),
                       [&](const ReportedParameter* known) { return known->name == parameter.name; }))
        all.push_back(&parameter);
  return all;
}

/// After these columns one per run, set flush right also where there are no rows.
std::vector<std::string> Head(std::vector<std::string> head, const std::vector<ComparedRun>& runs) {
  for (const ComparedRun& run : runs) head.push_back(run.name);
  return head;
}

}  // namespace

std::string RunTableHtml(const std::vector<ComparedRun>& runs) {
  const bool has_criteria = std::any_of(runs.begin(), runs.end(), [](const ComparedRun& run) {
    return run.result.contains("criteria") && run.result["criteria"].is_object();
  });
  Rows rows;
  for (const ComparedRun& run : runs) rows.push_back(RunRow(run, has_criteria));
  std::vector<std::string> head = {"run",       "fitted to", "recordings", "end",       "parameters",  "data",
                                   "residuals", "cost",      "misfit",     "fitted, %", "predicted, %"};
  if (has_criteria) head.insert(head.end(), {"AICc", "BIC"});
  head.insert(head.end(), {"evaluations", "agree"});
  return html::Table(head, rows) +
         "<p class=\"note\">Data: runs of one letter were fitted to the same recordings with the same weights and "
         "loss; "
         "cost" +
         (has_criteria ? ", AICc and BIC compare" : " compares") +
         " within a letter only. Misfit: residuals over noise and stated model error, about 1 is expected. Fitted and "
         "predicted: NMSE, mean over the run's own groups of channels, of fitted and of validation recordings. "
         "Agree: refinements that reach the same optimum." +
         (has_criteria ? "" : " AICc and BIC are shown of dampers on a bench.") + "</p>\n";
}

std::string ErrorTableHtml(const std::vector<ComparedRun>& runs, std::map<ChannelGroup, double> ComparedRun::*errors,
                           const std::string& joined) {
  std::set<ChannelGroup> groups;
  for (const ComparedRun& run : runs)
    for (const auto& [group, error] : run.*errors) groups.insert(group);
  const bool has_recordings =
      std::any_of(groups.begin(), groups.end(), [](const ChannelGroup& group) { return !group.first.empty(); });
  Rows rows;
  for (const ChannelGroup& group : groups) {
    std::vector<Cell> row;
    if (has_recordings) row.push_back(TextCell(group.first.empty() ? joined : group.first));
    row.push_back(NameCell(group.second));
    for (const ComparedRun& run : runs) {
      const auto found = (run.*errors).find(group);
      row.push_back(NumberCell(found == (run.*errors).end() ? "" : ShownNumber(found->second, 3)));
    }
    rows.push_back(std::move(row));
  }
  std::vector<std::string> head = {"NMSE, % of"};
  if (has_recordings) head.emplace_back("");
  return rows.empty() ? "" : html::Table(Head(head, runs), rows);
}

std::string ParametersSideBySideHtml(const std::vector<ComparedRun>& runs) {
  Rows rows;
  for (const ReportedParameter* parameter : AllParameters(runs)) {
    std::vector<Cell> row = {NameCell(parameter->name), TextCell(ShownUnit(parameter->unit))};
    for (const ComparedRun& run : runs) row.push_back(ValueCell(Find(run, parameter->name), parameter->unit));
    rows.push_back(std::move(row));
  }
  return rows.empty() ? ""
                      : html::Table(Head({"parameter", "unit"}, runs), rows) +
                            "<p class=\"note\">Fitted value, below it the confidence interval; blank where a run "
                            "did not fit "
                            "it.</p>\n";
}

}  // namespace fourpost
