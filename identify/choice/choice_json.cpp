#include <cmath>
#include <string>

#include "analysis/files/json_text.h"
#include "identify/choice/choice_answer.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

Json SummaryJson(const DrawSummary& summary) {
  return {{"mean", summary.mean}, {"sd", summary.sd}, {"interval_95", {summary.lower, summary.upper}}};
}

Json SettingJson(const ChoiceAnswer& answer, const Setting& setting) {
  Json json = Json::object();
  for (std::size_t k = 0; k < answer.knobs().size(); ++k)
    json[answer.knobs()[k].name] = PositionText(answer.knobs()[k], setting[k]);
  return json;
}

std::string ObjectiveNameOf(const ChoiceAnswer& answer, std::size_t objective) {
  return answer.MetricOf(answer.request.settings.objectives[objective]).name;
}

Json RowJson(const ChoiceAnswer& answer, const RatedSetting& row) {
  Json json = {{"setting", SettingJson(answer, row.setting)}};
  if (!row.failure.empty()) {
    json["failure"] = row.failure;
    return json;
  }
  Json objectives = Json::object();
  for (std::size_t o = 0; o < row.objectives.size(); ++o)
    objectives[ObjectiveNameOf(answer, o)] = {{"value", row.objectives[o]}, {"change", SummaryJson(row.changes[o])}};
  Json limits = Json::object();
  for (std::size_t l = 0; l < row.limits_met.size(); ++l)
    limits[answer.request.metrics[answer.request.settings.limits[l].metric].name] = row.limits_met[l];
  json.update({{"objectives", objectives},
               {"change", SummaryJson(row.change)},
               {"limits_met", limits},
               {"all_limits_met", row.all_met},
               {"is_admitted", row.is_admitted}});
  if (!answer.choice.best) return json;
  json.update({{"best_probability", row.best_probability},
               {"regret", row.regret},
               {"beside_best", SummaryJson(row.beside_best)},
               {"is_indistinct", row.is_indistinct},
               {"is_on_front", row.is_on_front}});
  return json;
}

Json ObjectivesJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const Objective& objective : answer.request.settings.objectives) {
    const Metric& metric = answer.MetricOf(objective);
    list.push_back({{"name", metric.name}, {"unit", metric.UnitInSi()}, {"weight", objective.weight}});
  }
  return list;
}

Json LimitsJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const MetricLimit& limit : answer.request.settings.limits) {
    const Metric& metric = answer.request.metrics[limit.metric];
    list.push_back({{"name", metric.name},
                    {"unit", metric.UnitInSi()},
                    {"most", limit.most ? Json(*limit.most) : Json(nullptr)},
                    {"least", limit.least ? Json(*limit.least) : Json(nullptr)}});
  }
  return list;
}

Json RoadsJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const ChoiceRoad& road : answer.request.settings.roads)
    list.push_back({{"name", road.name}, {"class", road.road_class}, {"speed", road.speed}, {"weight", road.weight}});
  return list;
}

Json ClicksJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const ClickLoss& click : answer.choice.clicks)
    list.push_back({{"knob", answer.knobs()[click.knob].name},
                    {"loss", NumberOrNull(click.loss)},
                    {"leaves_limits", click.leaves_limits}});
  return list;
}

/// What the draws carry: intervals of the car and of bench fits, by their confidence.
Json DoubtJson(const ChoiceAnswer& answer) {
  Json benches = Json::array();
  for (const BenchDoubt& bench : answer.benches)
    benches.push_back({{"run", bench.name}, {"confidence", bench.confidence}, {"knobs", bench.knobs}});
  return {{"car", answer.confidence.empty() ? Json(nullptr) : Json(answer.confidence)},
          {"benches", benches},
          {"exact_knobs", answer.ExactKnobs()},
          {"compared_by_histories", answer.choice.ComparedCount()},
          {"model_error_on_roads", false}};
}

Json DecidingJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const DecidingParameter& one : answer.choice.deciding)
    list.push_back(
        {{"parameter", answer.request.parameters[one.parameter]}, {"explained", one.explained}, {"gain", one.gain}});
  return list;
}

Json RunsJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const InformativeRun& run : answer.choice.runs)
    list.push_back({{"setting", SettingJson(answer, answer.choice.rows[run.setting].setting)},
                    {"gain", run.gain},
                    {"sd_before", run.sd_before},
                    {"sd_after", run.sd_after}});
  return list;
}

Json ChecksJson(const ChoiceAnswer& answer) {
  Json list = Json::array();
  for (const EngineCheck& check : answer.choice.checks)
    list.push_back({{"engine", check.engine == EngineCheck::Engine::kFull ? "full" : "histories"},
                    {"setting", SettingJson(answer, answer.choice.rows[check.row].setting)},
                    {"of", check.objective ? ObjectiveNameOf(answer, *check.objective) : "together"},
                    {"by_spectra", check.by_spectra},
                    {"by_engine", check.by_engine}});
  return list;
}

Json NamesOfRows(const ChoiceAnswer& answer, bool RatedSetting::*is) {
  Json list = Json::array();
  for (const RatedSetting& row : answer.choice.rows)
    if (row.*is) list.push_back(SettingJson(answer, row.setting));
  return list;
}

}  // namespace

Json ChoiceJson(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  Json notable = Json::array();
  for (const std::size_t row : answer.NotableRows(choice.rows.size()))
    notable.push_back(RowJson(answer, choice.rows[row]));
  return {{"run", answer.subject},
          {"doubt", answer.confidence.empty() ? Json(nullptr) : Json(answer.confidence)},
          {"doubt_contains", DoubtJson(answer)},
          {"draws", answer.draws()},
          {"seed", answer.request.settings.seed},
          {"lattice", choice.lattice},
          {"evaluated", choice.evaluated},
          {"was_searched", choice.was_searched},
          {"rated", choice.rows.size()},
          {"roads", RoadsJson(answer)},
          {"objectives", ObjectivesJson(answer)},
          {"limits", LimitsJson(answer)},
          {"certainty", answer.request.settings.certainty},
          {"present", RowJson(answer, choice.rows[choice.present])},
          {"best", choice.best ? RowJson(answer, choice.rows[*choice.best]) : Json(nullptr)},
          {"rival", choice.best ? SettingJson(answer, choice.rows[choice.rival].setting) : Json(nullptr)},
          {"notable", notable},
          {"indistinct", NamesOfRows(answer, &RatedSetting::is_indistinct)},
          {"front", NamesOfRows(answer, &RatedSetting::is_on_front)},
          {"clicks", ClicksJson(answer)},
          {"deciding", DecidingJson(answer)},
          {"test_next", RunsJson(answer)},
          {"engines", ChecksJson(answer)},
          {"warnings", WarningsJson(choice.findings)}};
}

}  // namespace fourpost
