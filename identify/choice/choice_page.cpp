#include "identify/choice/choice_page.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/report_document.h"
#include "analysis/report/shown_number.h"
#include "analysis/text/text_table.h"
#include "identify/choice/choice_charts.h"
#include "identify/choice/choice_words.h"
#include "identify/report/page_footer.h"

namespace fourpost {
namespace {

using html::NumberCell;
using html::TextCell;

/// All settings are in settings.csv.
constexpr std::size_t kPageRows = 60;

std::string Paragraph(const std::string& text) {
  return text.empty() ? "" : html::Element("p", "", html::Escaped(text)) + '\n';
}

std::string PageHeader(const ChoiceAnswer& answer) {
  return "<header>\n<h1>Settings of " + html::Escaped(answer.subject) + "</h1>\n<p class=\"facts\">" +
         html::Escaped(ScopeWords(answer)) +
         "</p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
}

std::string ShownPercent(double share) { return ShownDecimals(100 * share, 2); }

std::string ShownInterval(const DrawSummary& summary) {
  return ShownPercent(summary.lower) + " to " + ShownPercent(summary.upper);
}

/// In the metric's own unit.
std::string ShownValue(double si, const Metric& metric) {
  const std::optional<Unit> unit = ParseUnit(metric.unit.empty() ? "1" : metric.unit);
  return ShownNumber(unit ? si / unit->si : si, 4);
}

std::string Role(const ChoiceAnswer& answer, std::size_t row) {
  if (answer.choice.best == row) return row == answer.choice.present ? "best, now" : "best";
  return row == answer.choice.present ? "now" : "";
}

std::string RatedTable(const ChoiceAnswer& answer, const std::vector<std::size_t>& rows) {
  const SettingsFile& settings = answer.request.settings;
  const bool has_doubt = answer.has_doubt();
  std::vector<std::string> head = {"", "setting"};
  for (const Objective& objective : settings.objectives) {
    const Metric& metric = answer.MetricOf(objective);
    head.push_back(metric.name + (metric.unit.empty() ? "" : ", " + ShownUnit(metric.unit)));
    head.emplace_back("change, %");
  }
  head.emplace_back("together, %");
  if (has_doubt) head.insert(head.end(), {"sd, %", "95 % of cars", "P(best)", "regret, %"});
  if (!settings.limits.empty()) head.emplace_back("limits met, %");
  std::vector<std::vector<html::Cell>> cells;
  for (const std::size_t s : rows) {
    const RatedSetting& row = answer.choice.rows[s];
    std::vector<html::Cell> line = {{html::Element("b", "", Role(answer, s)), ""}, TextCell(answer.NameOf(s))};
    for (std::size_t o = 0; o < row.objectives.size(); ++o) {
      line.push_back(NumberCell(ShownValue(row.objectives[o], answer.MetricOf(settings.objectives[o]))));
      line.push_back(NumberCell(ShownPercent(row.changes[o].mean)));
    }
    line.push_back(NumberCell(ShownPercent(row.change.mean)));
    if (has_doubt) {
      line.push_back(NumberCell(ShownPercent(row.change.sd)));
      line.push_back(NumberCell(ShownInterval(row.change)));
      line.push_back(NumberCell(ShownDecimals(row.best_probability, 2)));
      line.push_back(NumberCell(ShownPercent(row.regret)));
    }
    if (!settings.limits.empty()) line.push_back(NumberCell(ShownNumber(100 * row.all_met, 3)));
    cells.push_back(std::move(line));
  }
  return cells.empty() ? "" : html::Table(head, cells);
}

std::string PageSummary(const ChoiceAnswer& answer) {
  constexpr std::size_t kSummaryRows = 8;
  const Choice& choice = answer.choice;
  const char* verdict = !choice.best                      ? "verdict poor"
                        : choice.findings.items().empty() ? "verdict good"
                                                          : "verdict fair";
  std::string html = html::Element("p", verdict, "<strong>" + html::Escaped(VerdictWords(answer)) + "</strong>") +
                     '\n' + RatedTable(answer, answer.NotableRows(kSummaryRows)) + Paragraph(DoubtWords(answer)) +
                     Paragraph(IndistinctWords(answer)) + Paragraph(ClickWords(answer));
  std::string findings;
  for (const Diagnostic& finding : choice.findings.ByWeight())
    findings += html::Element("li", "", html::Escaped(finding.message)) + '\n';
  if (!findings.empty()) html += "<ul>\n" + findings + "</ul>\n";
  return html::Section("summary", "Summary", html);
}

std::string MapSection(const ChoiceAnswer& answer) {
  const std::string svg = SettingsSvg(answer);
  if (svg.empty()) return "";
  return html::Section("map", "Map of settings",
                       html::Picture(svg, "Change of all objectives together over two knobs"));
}

std::string FrontSection(const ChoiceAnswer& answer) {
  const std::string svg = FrontSvg(answer);
  if (svg.empty()) return "";
  const std::string words = "The front has " + std::to_string(answer.choice.front.size()) +
                            " settings, of means over the cars; weights choose one of them.";
  return html::Section("front", "Two objectives",
                       html::Picture(svg, "Both objectives of every setting, and their front") +
                           RatedTable(answer, answer.choice.front) + "<p class=\"note\">" + words + "</p>\n");
}

std::string SpectraSection(const ChoiceAnswer& answer) {
  const std::string svg = SpectraSvg(answer);
  if (svg.empty()) return "";
  return html::Section(
      "spectra", "Best beside now",
      html::Picture(svg, "Spectra of accelerations and tyre loads at the best and the present setting"));
}

std::string DoubtSection(const ChoiceAnswer& answer) {
  if (answer.choice.deciding.empty()) return "";
  std::vector<std::vector<html::Cell>> rows;
  for (const DecidingParameter& one : answer.choice.deciding)
    rows.push_back({{html::Code(answer.request.parameters[one.parameter]), ""},
                    NumberCell(ShownNumber(100 * one.explained, 2)),
                    NumberCell(ShownPercent(one.gain))});
  return html::Section(
      "doubt", "Whose doubt decides",
      Paragraph(DecidingWords(answer)) + html::Table({"parameter", "of the variance, %", "regret falls by, %"}, rows) +
          "<p class=\"note\">Variance of the difference between the best setting and its rival, by linear "
          "regression over the cars; shares of correlated parameters overlap. Regret: expected, of the "
          "best setting, if that parameter were known.</p>\n");
}

std::string NextSection(const ChoiceAnswer& answer) {
  const std::string words = RunWords(answer);
  if (words.empty()) return "";
  if (answer.choice.runs.empty()) return html::Section("next", "What to test next", Paragraph(words));
  std::vector<std::vector<html::Cell>> rows;
  for (const InformativeRun& run : answer.choice.runs)
    rows.push_back({TextCell(answer.NameOf(run.setting)), NumberCell(ShownPercent(run.gain)),
                    NumberCell(ShownPercent(run.sd_before)), NumberCell(ShownPercent(run.sd_after))});
  return html::Section("next", "What to test next",
                       Paragraph(words) +
                           html::Table({"setting", "regret falls by, %", "sd before, %", "sd after, %"}, rows) +
                           "<p class=\"note\">Each given the runs above it: knowledge gradient of correlated normal "
                           "beliefs.</p>\n");
}

std::string EngineSection(const ChoiceAnswer& answer) {
  if (answer.choice.checks.empty()) return "";
  std::vector<std::vector<html::Cell>> rows;
  for (const EngineCheck& check : answer.choice.checks)
    rows.push_back(
        {TextCell(answer.NameOf(check.row)),
         TextCell(check.objective ? answer.MetricOf(answer.request.settings.objectives[*check.objective]).name
                                  : "together"),
         NumberCell(ShownPercent(check.by_spectra)),
         TextCell(check.engine == EngineCheck::Engine::kFull ? "multibody system" : "reduced model over time"),
         NumberCell(ShownPercent(check.by_engine))});
  return html::Section("engines", "Three engines",
                       Paragraph(EngineWords(answer)) +
                           html::Table({"setting", "change of", "by spectra, %", "engine", "by engine, %"}, rows) +
                           "<p class=\"note\">At the fitted values, against the present setting by the same "
                           "engine.</p>\n");
}

std::string AllSection(const ChoiceAnswer& answer) {
  std::vector<std::size_t> rows;
  for (std::size_t s = 0; s < answer.choice.rows.size(); ++s)
    if (answer.choice.rows[s].failure.empty()) rows.push_back(s);
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return answer.choice.rows[a].change.mean < answer.choice.rows[b].change.mean;
  });
  const bool is_cut = rows.size() > kPageRows;
  rows.resize(std::min(rows.size(), kPageRows));
  return html::Section(
      "settings", "Settings",
      RatedTable(answer, rows) +
          (is_cut ? "<p class=\"note\">The best " + std::to_string(kPageRows) + "; settings.csv has all.</p>\n" : ""));
}

std::string AskedSection(const ChoiceAnswer& answer) {
  const SettingsFile& settings = answer.request.settings;
  std::vector<std::vector<html::Cell>> roads;
  for (const ChoiceRoad& road : settings.roads)
    roads.push_back({TextCell(road.name), TextCell(road.road_class), NumberCell(ShownNumber(3.6 * road.speed, 4)),
                     NumberCell(ShownNumber(100 * road.weight, 3))});
  std::string html = html::Table({"road", "ISO 8608", "speed, km/h", "weight, %"}, roads);
  std::vector<std::vector<html::Cell>> wanted;
  for (const Objective& objective : settings.objectives)
    wanted.push_back({TextCell(answer.MetricOf(objective).name), TextCell(answer.MetricOf(objective).words),
                      TextCell("least, with weight " + ShownNumber(objective.weight, 3))});
  for (const MetricLimit& limit : settings.limits) {
    const Metric& metric = answer.request.metrics[limit.metric];
    const std::string unit = metric.unit.empty() ? "" : ' ' + metric.unit;
    std::string bounds;
    if (limit.most) bounds = "at most " + ShownValue(*limit.most, metric) + unit;
    if (limit.least) bounds += (bounds.empty() ? "" : ", ") + ("at least " + ShownValue(*limit.least, metric)) + unit;
    wanted.push_back({TextCell(metric.name), TextCell(metric.words), TextCell(bounds)});
  }
  return html::Section("asked", "What was asked for", html + html::Table({"metric", "what it is", "wanted"}, wanted));
}

}  // namespace

std::string ChoicePage(const ChoiceAnswer& answer) {
  const std::string body = PageHeader(answer) + "<nav id=\"contents\"></nav>\n<main>\n" + PageSummary(answer) +
                           MapSection(answer) + FrontSection(answer) + SpectraSection(answer) + DoubtSection(answer) +
                           NextSection(answer) + EngineSection(answer) + AllSection(answer) + AskedSection(answer) +
                           "</main>\n" +
                           PageFooter(answer.subject + " and " + answer.request.settings.file.filename().string());
  return ReportDocument("Settings of " + answer.subject + " \u2013 fourpost", body, "{}");
}

}  // namespace fourpost
