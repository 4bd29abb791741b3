#include "identify/comparison/comparison_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

Json IntervalJson(const Interval& interval) {
  return Json::array({NumberOrNull(interval.lower), NumberOrNull(interval.upper)});
}

/// Of the runs' evaluations, or of their costs: mean, and standard deviation about it; null when a run has none.
template <typename Number>
Json Spread(const std::vector<RunOutcome>& outcomes, Number RunOutcome::*number) {
  const auto count = static_cast<double>(outcomes.size());
  double mean = 0;
  double squares = 0;
  for (const RunOutcome& outcome : outcomes) mean += static_cast<double>(outcome.*number) / count;
  for (const RunOutcome& outcome : outcomes) squares += std::pow(static_cast<double>(outcome.*number) - mean, 2);
  return {{"mean", NumberOrNull(mean)}, {"sd", NumberOrNull(std::sqrt(squares / (count - 1)))}};
}

/// A row of [evaluations, cost] for each run.
Json RunsJson(const std::vector<RunOutcome>& outcomes) {
  Json runs = Json::array();
  for (const RunOutcome& outcome : outcomes)
    runs.push_back(Json::array({outcome.evaluations, NumberOrNull(outcome.cost)}));
  return runs;
}

Json GainJson(const SearchGain& gain) {
  return {{"count", gain.count}, {"evaluations", gain.evaluations}, {"successes", gain.successes}};
}

Json MethodJson(const MethodSummary& method, bool time) {
  Json ends = Json::object();
  for (const auto& [end, count] : method.ends) ends[std::string(SearchEndName(end))] = count;
  Json settings = Json::object();
  for (const auto& [key, value] : method.settings) settings[key] = value;
  Json json = {{"name", method.name},
               {"algorithm", method.algorithm.empty() ? Json(nullptr) : Json(method.algorithm)},
               {"runs", method.outcomes.size()},
               {"successes", method.successes},
               {"success_share_95", IntervalJson(method.success_share)},
               {"evaluations_mean", method.evaluations_mean},
               {"expected_evaluations", NumberOrNull(method.expected_evaluations)},
               {"expected_evaluations_95", IntervalJson(method.expected_interval)},
               {"cost_median", NumberOrNull(method.cost_median)},
               {"cost_worst", NumberOrNull(method.cost_worst)},
               {"cost", Spread(method.outcomes, &RunOutcome::cost)},
               {"evaluations", Spread(method.outcomes, &RunOutcome::evaluations)},
               {"ends", ends},
               {"outcomes", RunsJson(method.outcomes)},
               {"accelerations", GainJson(method.accelerations)},
               {"migrations", GainJson(method.migrations)},
               {"settings", settings}};
  if (time) json["seconds"] = Spread(method.outcomes, &RunOutcome::seconds);
  return json;
}

}  // namespace

std::string ComparisonJson(const Comparison& comparison, const std::string& study, std::uint64_t seed, bool time) {
  Json methods = Json::array();
  for (const MethodSummary& method : comparison.methods) methods.push_back(MethodJson(method, time));
  const Json json = {{"study", study},
                     {"seed", seed},
                     {"parameters", comparison.parameters},
                     {"residuals", comparison.residuals},
                     {"target_cost", NumberOrNull(comparison.target_cost)},
                     {"interrupted", comparison.interrupted},
                     {"methods", methods}};
  return JsonText(json);
}

}  // namespace fourpost
