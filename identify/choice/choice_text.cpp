#include <string>
#include <vector>

#include "analysis/text/text_table.h"
#include "identify/choice/choice_answer.h"
#include "identify/choice/choice_words.h"

namespace fourpost {
namespace {

constexpr std::size_t kShownRows = 12;

std::string RoleOf(const ChoiceAnswer& answer, std::size_t row) {
  if (answer.choice.best == row) return row == answer.choice.present ? "best, now" : "best";
  return row == answer.choice.present ? "now" : "";
}

std::string SettingsTable(const ChoiceAnswer& answer) {
  const bool has_doubt = answer.has_doubt();
  std::vector<std::string> head = {"", "setting"};
  for (const Objective& objective : answer.request.settings.objectives) {
    const Metric& metric = answer.MetricOf(objective);
    head.push_back(metric.name + (metric.unit.empty() ? "" : ", " + metric.unit));
    head.emplace_back("change, %");
  }
  head.emplace_back("together, %");
  if (has_doubt) head.insert(head.end(), {"sd", "95 % of cars", "P(best)", "regret, %"});
  if (!answer.request.settings.limits.empty()) head.emplace_back("limits met, %");
  TextTable table(head);
  for (const std::size_t s : answer.NotableRows(kShownRows)) {
    const RatedSetting& row = answer.choice.rows[s];
    std::vector<std::string> cells = {RoleOf(answer, s), answer.NameOf(s)};
    for (std::size_t o = 0; o < row.objectives.size(); ++o) {
      cells.push_back(InUnit(row.objectives[o], answer.MetricOf(answer.request.settings.objectives[o]).unit, 4));
      cells.push_back(TwoDecimals(row.changes[o].mean));
    }
    cells.push_back(TwoDecimals(row.change.mean));
    if (has_doubt) {
      cells.push_back(TwoDecimals(row.change.sd));
      cells.push_back(IntervalPercent(row.change));
      cells.push_back(TwoDecimals(row.best_probability / 100));
      cells.push_back(TwoDecimals(row.regret));
    }
    if (!answer.request.settings.limits.empty()) cells.push_back(Rounded(100 * row.all_met, 3));
    table.Add(std::move(cells));
  }
  return table.Format();
}

std::string ChecksTable(const ChoiceAnswer& answer) {
  if (answer.choice.checks.empty()) return "";
  TextTable table({"engines", "setting", "change of", "spectra, %", "engine, %"});
  for (const EngineCheck& check : answer.choice.checks)
    table.Add(
        {check.engine == EngineCheck::Engine::kFull ? "multibody" : "histories", answer.NameOf(check.row),
         check.objective ? answer.MetricOf(answer.request.settings.objectives[*check.objective]).name : "together",
         TwoDecimals(check.by_spectra), TwoDecimals(check.by_engine)});
  return '\n' + table.Format();
}

}  // namespace

std::string ChoiceText(const ChoiceAnswer& answer) {
  std::string text = ScopeWords(answer) + "\n\n" + SettingsTable(answer) + '\n';
  for (const std::string& words : {VerdictWords(answer), DoubtWords(answer), IndistinctWords(answer),
                                   ClickWords(answer), DecidingWords(answer), RunWords(answer), EngineWords(answer)})
    if (!words.empty()) text += words + '\n';
  return text + ChecksTable(answer);
}

}  // namespace fourpost
