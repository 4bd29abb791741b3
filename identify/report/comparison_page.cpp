#include "identify/report/comparison_page.h"

#include <set>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/report_document.h"
#include "identify/report/comparison_curves.h"
#include "identify/report/comparison_tables.h"
#include "identify/report/comparison_verdict.h"
#include "identify/report/page_footer.h"
#include "identify/report/ranked_run.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string Header(const std::vector<ComparedRun>& runs) {
  std::string names;
  for (const ComparedRun& run : runs) names += (names.empty() ? "" : ", ") + run.name;
  return "<header>\n<h1>" + std::to_string(runs.size()) + " fits compared</h1>\n<p class=\"facts\">" +
         html::Escaped(names) + "</p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
}

/// "the fits a, b (by fourpost 0.1.0)", versions where they are known.
std::string Sources(const std::vector<ComparedRun>& runs) {
  std::string text = "the fits ";
  std::set<std::string> versions;
  for (const ComparedRun& run : runs) {
    text += (&run == &runs.front() ? "" : ", ") + run.name;
    versions.insert(TextAt(run.result.value("versions", nlohmann::json()), "fourpost"));
  }
  versions.erase("");
  std::string by;
  for (const std::string& version : versions) by += (by.empty() ? " (by fourpost " : " and ") + version;
  return text + (by.empty() ? "" : by + ")");
}

std::string Curves(const OrderedJson& curves, const std::string& part, const std::string& title) {
  if (curves[part].empty()) return "";
  return html::Section(part, title,
                       "<div class=\"drawn\" data-draw=\"compared_" + part +
                           "\"><noscript><p class=\"note\">The charts need JavaScript.</p></noscript></div>\n");
}

std::string Errors(const std::vector<ComparedRun>& runs) {
  const std::string sines = ErrorTableHtml(runs, &ComparedRun::sines);
  const std::string fitted = ErrorTableHtml(runs, &ComparedRun::fitted);
  const std::string predicted = ErrorTableHtml(runs, &ComparedRun::predicted);
  std::string html;
  if (!sines.empty()) html += "<h3>Fitted stepped sines</h3>\n" + sines;
  if (!fitted.empty()) html += "<h3>Fitted channels</h3>\n" + fitted;
  if (!predicted.empty()) html += "<h3>Validation</h3>\n" + predicted;
  return html +
         "<p class=\"note\">Channels that differ by their place only, such as front and rear or the four corners, are "
         "one "
         "group, of which the mean is shown; the least of each row is bold.</p>\n";
}

/// Of dampers fitted to the same recordings.
std::optional<ModelRanking> RankingOf(const std::vector<ComparedRun>& runs) {
  Diagnostics not_ranked;
  std::vector<FittedModel> models = FittedModels(runs, not_ranked);
  if (not_ranked.HasErrors()) return std::nullopt;
  return Rank(std::move(models));
}

}  // namespace

std::string ComparisonPage(std::vector<std::pair<std::string, RunContents>> folders) {
  const std::vector<ComparedRun> runs = ComparedRuns(std::move(folders));
  const OrderedJson curves = ComparisonCurves(runs);
  const std::string body =
      Header(runs) + "<nav id=\"contents\"></nav>\n<main>\n" +
      html::Section("summary", "Summary", VerdictHtml(runs, RankingOf(runs)) + RunTableHtml(runs)) +
      html::Section("errors", "Errors by group of channels", Errors(runs)) +
      html::Section("parameters", "Parameters", ParametersSideBySideHtml(runs)) +
      Curves(curves, "responses", "Frequency responses") + Curves(curves, "histories", "Time histories") +
      Curves(curves, "bench", "Damper bench") + "</main>\n" + PageFooter(Sources(runs));
  const OrderedJson data = {{"comparison", curves}};
  return ReportDocument("Comparison of fits \u2013 fourpost report", body, CompactJson(data));
}

}  // namespace fourpost
