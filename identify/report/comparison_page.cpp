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

std::string Curves(const std::vector<ComparedCurves>& curves) {
  std::string html;
  for (const ComparedCurves& part : curves)
    if (!part.curves.empty())
      html += html::Section(part.id, part.title, html::Drawn("compared_" + part.id, "The charts need JavaScript."));
  return html;
}

/// "stepped sines", of which a result states errors of all together.
std::string JoinedName(ExperimentReports experiments) {
  for (const ExperimentReport* experiment : experiments)
    if (experiment->JoinsRecordings()) return std::string(experiment->Name());
  return "";
}

std::string Errors(const std::vector<ComparedRun>& runs, const std::string& joined) {
  const std::string recordings = ErrorTableHtml(runs, &ComparedRun::recordings, joined);
  const std::string fitted = ErrorTableHtml(runs, &ComparedRun::fitted, joined);
  const std::string predicted = ErrorTableHtml(runs, &ComparedRun::predicted, joined);
  std::string html;
  if (!recordings.empty()) html += "<h3>Fitted " + joined + "</h3>\n" + recordings;
  if (!fitted.empty()) html += "<h3>Fitted channels</h3>\n" + fitted;
  if (!predicted.empty()) html += "<h3>Validation</h3>\n" + predicted;
  return html +
         "<p class=\"note\">Channels that differ by their place only, such as front and rear or the four corners, are "
         "one group, of which the mean is shown.</p>\n" +
         html::Drawn("compared_errors");
}

/// Of dampers fitted to the same recordings.
std::optional<ModelRanking> RankingOf(const std::vector<ComparedRun>& runs) {
  Diagnostics not_ranked;
  std::vector<FittedModel> models = FittedModels(runs, not_ranked);
  if (not_ranked.HasErrors()) return std::nullopt;
  return Rank(std::move(models));
}

}  // namespace

std::string ComparisonPage(std::vector<std::pair<std::string, RunContents>> folders, ExperimentReports experiments) {
  const std::vector<ComparedRun> runs = ComparedRuns(std::move(folders), experiments);
  const std::vector<ComparedCurves> curves = CurvesOf(runs, experiments);
  const std::string body =
      Header(runs) + "<nav id=\"contents\"></nav>\n<main>\n" +
      html::Section("summary", "Summary", VerdictHtml(runs, RankingOf(runs)) + RunTableHtml(runs)) +
      html::Section("errors", "Errors by group of channels", Errors(runs, JoinedName(experiments))) +
      html::Section("parameters", "Parameters",
                    html::Drawn("compared_parameters") +
                        html::Folded("All parameters of all runs", ParametersSideBySideHtml(runs))) +
      Curves(curves) + "</main>\n" + PageFooter(Sources(runs));
  const OrderedJson data = {{"comparison", ComparisonJson(runs, curves)}};
  return ReportDocument("Comparison of fits \u2013 fourpost report", body, CompactJson(data));
}

}  // namespace fourpost
