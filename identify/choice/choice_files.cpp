#include <string>
#include <utility>
#include <vector>

#include "analysis/files/csv_writer.h"
#include "identify/choice/choice_answer.h"
#include "identify/choice/choice_charts.h"
#include "identify/choice/choice_page.h"

namespace fourpost {
namespace {

/// Names above, units below them.
class ChoiceTable {
 public:
  void Add(const std::string& name, const std::string& unit) {
    names_.push_back(name);
    units_.push_back(unit);
  }

  CsvWriter Begin() const {
    CsvWriter csv(names_);
    for (const std::string& unit : units_) csv.Add(unit);
    return csv;
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::string> units_;
};

void AddKnobs(const ChoiceAnswer& answer, ChoiceTable& table) {
  for (const Knob& knob : answer.knobs()) table.Add(knob.name, "");
}

void AddSetting(const ChoiceAnswer& answer, const Setting& setting, CsvWriter& csv) {
  for (std::size_t k = 0; k < setting.size(); ++k) csv.Add(PositionText(answer.knobs()[k], setting[k]));
}

void AddSummary(const DrawSummary& summary, CsvWriter& csv) {
  for (const double share : {summary.mean, summary.sd, summary.lower, summary.upper}) csv.Add(100 * share);
}

void AddSummaryColumns(const std::string& name, ChoiceTable& table) {
  for (const char* part : {"", "_sd", "_lower", "_upper"}) table.Add(name + part, "%");
}

void AddRow(const ChoiceAnswer& answer, const RatedSetting& row, CsvWriter& csv) {
  const SettingsFile& settings = answer.request.settings;
  AddSetting(answer, row.setting, csv);
  const bool has_answer = row.failure.empty();
  const DrawSummary none = {std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  for (std::size_t o = 0; o < settings.objectives.size(); ++o) {
    csv.Add(has_answer ? row.objectives[o] : std::nan(""));
    AddSummary(has_answer ? row.changes[o] : none, csv);
  }
  AddSummary(has_answer ? row.change : none, csv);
  const bool is_rated = has_answer && answer.choice.best.has_value();
  AddSummary(is_rated ? row.beside_best : none, csv);
  csv.Add(is_rated ? row.best_probability : std::nan("")).Add(is_rated ? 100 * row.regret : std::nan(""));
  for (std::size_t l = 0; l < settings.limits.size(); ++l) csv.Add(has_answer ? 100 * row.limits_met[l] : std::nan(""));
  csv.Add(has_answer ? 100 * row.all_met : std::nan(""));
  for (const bool is : {row.is_admitted, row.is_indistinct, row.is_on_front}) csv.Add(is ? 1.0 : 0.0);
  csv.Add(row.failure);
}

std::string SettingsCsv(const ChoiceAnswer& answer) {
  ChoiceTable table;
  AddKnobs(answer, table);
  for (const Objective& objective : answer.request.settings.objectives) {
    const Metric& metric = answer.MetricOf(objective);
    table.Add(metric.name, metric.UnitInSi());
    AddSummaryColumns(metric.name + "_change", table);
  }
  AddSummaryColumns("change", table);
  AddSummaryColumns("beside_best", table);
  table.Add("best_probability", "1");
  table.Add("regret", "%");
  for (const MetricLimit& limit : answer.request.settings.limits)
    table.Add("met_" + answer.request.metrics[limit.metric].name, "%");
  table.Add("limits_met", "%");
  for (const char* name : {"is_admitted", "is_indistinct", "is_on_front"}) table.Add(name, "1");
  table.Add("failure", "");
  CsvWriter csv = table.Begin();
  for (const RatedSetting& row : answer.choice.rows) AddRow(answer, row, csv);
  return csv.text();
}

std::string TestNextCsv(const ChoiceAnswer& answer) {
  ChoiceTable table;
  table.Add("order", "1");
  AddKnobs(answer, table);
  for (const char* name : {"gain", "sd_before", "sd_after"}) table.Add(name, "%");
  CsvWriter csv = table.Begin();
  double order = 0;
  for (const InformativeRun& run : answer.choice.runs) {
    csv.Add(++order);
    AddSetting(answer, answer.choice.rows[run.setting].setting, csv);
    csv.Add(100 * run.gain).Add(100 * run.sd_before).Add(100 * run.sd_after);
  }
  return csv.text();
}

/// All metrics of the present setting, and of the best one.
std::string MetricsCsv(const ChoiceAnswer& answer) {
  CsvWriter csv({"metric", "unit", "road", "now", "best"});
  for (Eigen::Index m = 0; m < answer.present_metrics.cols(); ++m) {
    const Metric& metric = answer.request.metrics[static_cast<std::size_t>(m)];
    for (Eigen::Index road = 0; road < answer.present_metrics.rows(); ++road) {
      csv.Add(metric.name).Add(metric.UnitInSi());
      csv.Add(answer.request.settings.roads[static_cast<std::size_t>(road)].name).Add(answer.present_metrics(road, m));
      csv.Add(answer.best_metrics.size() > 0 ? answer.best_metrics(road, m) : std::nan(""));
    }
  }
  return csv.text();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> ChoiceFiles(const ChoiceAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> files = {{"settings.csv", SettingsCsv(answer)},
                                                            {"metrics.csv", MetricsCsv(answer)},
                                                            {"test_next.csv", TestNextCsv(answer)},
                                                            {"choose.html", ChoicePage(answer)}};
  for (auto& [name, svg] : std::vector<std::pair<std::string, std::string>>{
           {"settings.svg", SettingsSvg(answer)}, {"front.svg", FrontSvg(answer)}, {"spectra.svg", SpectraSvg(answer)}})
    if (!svg.empty()) files.emplace_back(name, std::move(svg));
  return files;
}

}  // namespace fourpost
