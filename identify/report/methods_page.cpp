#include "identify/report/methods_page.h"

#include <algorithm>
#include <cmath>

#include "analysis/report/html.h"
#include "analysis/report/report_document.h"
#include "analysis/report/shown_number.h"
#include "identify/comparison/methods_chart.h"
#include "identify/report/page_footer.h"

namespace fourpost {
namespace {

using html::NumberCell;
using html::TextCell;

std::string Header(const Comparison& comparison, const std::string& study) {
  return "<header>\n<h1>" + html::Escaped(study) + ": " + std::to_string(comparison.methods.size()) +
         " methods compared</h1>\n<p class=\"facts\">" + std::to_string(comparison.parameters) + " parameters, " +
         std::to_string(comparison.residuals) +
         " residuals</p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
}

std::string Solved(const MethodSummary& method) {
  return std::to_string(method.successes) + " of " + std::to_string(method.outcomes.size());
}

/// By the evaluations that a success costs, failures included.
std::string Verdict(const Comparison& comparison, const std::string& rule) {
  std::vector<const MethodSummary*> order;
  for (const MethodSummary& method : comparison.methods)
    if (method.successes > 0) order.push_back(&method);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->expected_evaluations < b->expected_evaluations; });
  if (order.empty()) return "No run of any method solved it. " + html::Escaped(rule);
  const auto described = [](const MethodSummary& method) {
    return html::Escaped(method.name) + " solved it in " + Solved(method) + " runs, at " +
           ShownNumber(method.expected_evaluations, 3) + " evaluations per success";
  };
  std::string text = "<strong>" + described(*order[0]) + "</strong>";
  if (order.size() > 1) {
    text += "; next " + described(*order[1]);
    if (order[1]->expected_interval.lower <= order[0]->expected_interval.upper)
      text += "; these runs do not separate the two, their intervals overlap";
  }
  return text + ". " + html::Escaped(rule);
}

std::string Ends(const MethodSummary& method) {
  std::string text;
  for (const auto& [end, count] : method.ends)
    text += (text.empty() ? "" : ", ") + std::string(SearchEndName(end)) + " (" + std::to_string(count) + ")";
  return text;
}

std::string Range(const Interval& interval, int digits) {
  return ShownNumber(interval.lower, digits) + " to " + ShownNumber(interval.upper, digits);
}

std::string MethodTable(const Comparison& comparison, bool time) {
  std::vector<std::string> head = {"method",      "solved", "share, 95 %", "evaluations",
                                   "per success", "95 %",   "median cost", "worst cost"};
  if (time) head.emplace_back("processor, s");
  head.emplace_back("ended by");
  std::vector<std::vector<html::Cell>> rows;
  for (const MethodSummary& method : comparison.methods) {
    const Interval percent = {100 * method.success_share.lower, 100 * method.success_share.upper};
    rows.push_back({{html::Element("b", "", html::Escaped(method.name)), ""},
                    NumberCell(Solved(method)),
                    NumberCell(Range(percent, 3)),
                    NumberCell(ShownNumber(method.evaluations_mean, 4)),
                    NumberCell(ShownNumber(method.expected_evaluations, 4)),
                    NumberCell(Range(method.expected_interval, 4)),
                    NumberCell(ShownNumber(method.cost_median, 5)),
                    NumberCell(ShownNumber(method.cost_worst, 5))});
    if (time) rows.back().push_back(NumberCell(ShownNumber(method.MeanSeconds(), 3)));
    rows.back().push_back({html::Escaped(Ends(method)), "wrap"});
  }
  return html::Table(head, rows) +
         "<p class=\"note\">Evaluations: mean of all runs. Per success: evaluations of all runs over the number of "
         "runs "
         "that solved it, with a bootstrap interval; the interval of the share is Wilson's.</p>\n";
}

std::string SettingsTable(const Comparison& comparison) {
  std::vector<std::vector<html::Cell>> rows;
  for (const MethodSummary& method : comparison.methods) {
    std::string settings;
    for (const auto& [key, value] : method.settings) settings += (settings.empty() ? "" : ", ") + key + ' ' + value;
    rows.push_back({TextCell(method.name), {html::Escaped(settings), "wrap"}});
  }
  return html::Table({"method", "settings"}, rows);
}

bool IsAnySolved(const Comparison& comparison) {
  return std::any_of(comparison.methods.begin(), comparison.methods.end(),
                     [](const MethodSummary& method) { return method.successes > 0; });
}

}  // namespace

std::string MethodsPage(const Comparison& comparison, const std::string& study, const std::string& rule, bool time) {
  const bool is_solved = IsAnySolved(comparison);
  std::string runs = MethodTable(comparison, time);
  if (is_solved)
    runs = html::Picture(MethodsSvg(study + ": evaluations per success", comparison),
                         "Share of each method's runs that had solved the problem, over evaluations") +
           runs;
  const std::string verdict =
      html::Element("p", is_solved ? "verdict good" : "verdict poor", Verdict(comparison, rule)) + '\n';
  const std::string stopped =
      comparison.interrupted ? "<p class=\"note\">Interrupted: unfinished runs are left out.</p>\n" : "";
  const std::string body = Header(comparison, study) + "<nav id=\"contents\"></nav>\n<main>\n" +
                           html::Section("summary", "Summary", verdict + stopped + runs) +
                           html::Section("settings", "Settings", SettingsTable(comparison)) + "</main>\n" +
                           PageFooter("the study " + study);
  return ReportDocument(study + " \u2013 methods compared by fourpost", body, "{}");
}

}  // namespace fourpost
