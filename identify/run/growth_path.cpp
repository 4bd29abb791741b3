#include "identify/run/growth_path.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

Json AdditionJson(const GrowthAddition& addition) {
  return {{"added", addition.words},     {"mechanism", addition.mechanism},  {"elements", addition.elements},
          {"variant", addition.variant}, {"amount", addition.amount},        {"count", addition.count},
          {"choices", addition.choices}, {"parameters", addition.parameters}};
}

/// Throws where it is none.
GrowthAddition AdditionOf(const nlohmann::json& json) {
  return {.words = json.at("added"),
          .mechanism = json.at("mechanism"),
          .elements = json.at("elements"),
          .variant = json.at("variant"),
          .amount = json.at("amount"),
          .count = json.at("count"),
          // Paths of versions that charged all alike.
          .choices = json.value("choices", 1),
          .parameters = json.at("parameters")};
}

Json StepJson(const GrowthStep& step) {
  Json json = AdditionJson(step.addition);
  json.update({{"takes_back", step.takes_back},
               {"folder", step.folder},
               {"cost", NumberOrNull(step.cost)},
               {"misfit", NumberOrNull(step.misfit)},
               {"criterion_change", NumberOrNull(step.criterion)},
               {"validation_percent", NumberOrNull(step.validation_percent)},
               {"effective_residuals", step.effective},
               {"residuals", step.residuals},
               {"tried", step.tried},
               {"at_bound", step.at_bound},
               {"kept", step.is_kept},
               {"reason", step.reason}});
  return json;
}

/// Throws where it is none.
GrowthStep StepOf(const nlohmann::json& json) {
  return {.addition = AdditionOf(json),
          .takes_back = json.at("takes_back"),
          .folder = json.at("folder"),
          .cost = NumberAt(json, "cost"),
          .misfit = NumberAt(json, "misfit"),
          .criterion = NumberAt(json, "criterion_change"),
          .validation_percent = NumberAt(json, "validation_percent"),
          .effective = json.at("effective_residuals"),
          .residuals = json.at("residuals"),
          .tried = json.at("tried"),
          .at_bound = json.at("at_bound"),
          .is_kept = json.at("kept"),
          .reason = json.at("reason")};
}

Json RoundJson(const std::optional<GrowthRound>& round) {
  if (!round) return nullptr;
  Json candidates = Json::array();
  for (const GrowthCandidate& one : round->candidates) {
    Json json = AdditionJson(one.addition);
    json.update({{"takes_back", one.takes_back}, {"folder", one.folder}, {"effective_residuals", one.effective}});
    candidates.push_back(std::move(json));
  }
  return {
      {"residuals", round->residuals}, {"tried", round->tried}, {"first", round->first}, {"candidates", candidates}};
}

std::optional<GrowthRound> RoundOf(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  GrowthRound round{.residuals = json.at("residuals"), .tried = json.at("tried"), .first = json.at("first")};
  for (const nlohmann::json& one : json.at("candidates"))
    round.candidates.push_back({.addition = AdditionOf(one),
                                .takes_back = one.at("takes_back"),
                                .folder = one.at("folder"),
                                .effective = one.at("effective_residuals")});
  return round;
}

/// A step that failed has no result.
bool IsThere(const std::filesystem::path& output, const GrowthStep& step) {
  if (!std::isfinite(step.cost)) return !step.is_kept;
  const nlohmann::json result = ReadResultFile(output / step.folder / "fit" / "result.json");
  return NumberAt(result, "cost") == step.cost;
}

/// Those of whose studies something is missing cannot be tried.
bool IsThere(const std::filesystem::path& output, const GrowthRound& round) {
  return std::all_of(round.candidates.begin(), round.candidates.end(), [&](const GrowthCandidate& one) {
    return std::filesystem::exists(output / one.folder / "study.yaml") &&
           std::filesystem::exists(output / one.folder / "vehicle.urdf");
  });
}

}  // namespace

std::size_t GrowthPath::LastKept() const {
  std::size_t last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i].is_kept) last = i;
  return last;
}

std::size_t GrowthPath::NumberOf(std::size_t place) const {
  if (place == 0) return 0;
  const auto begin = steps.begin() + 1;
  return 1 + static_cast<std::size_t>(std::count_if(begin, steps.begin() + static_cast<std::ptrdiff_t>(place),
                                                    [](const GrowthStep& step) { return step.is_kept; }));
}

std::vector<std::size_t> GrowthPath::Standing() const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i].is_kept && !steps[i].IsOfStudy() && steps[i].takes_back.empty() && !TakenBackBy(i))
      places.push_back(i);
  return places;
}

std::vector<std::string> GrowthPath::Added() const {
  std::vector<std::string> words;
  for (const std::size_t place : Standing()) words.push_back(steps[place].addition.words);
  return words;
}

std::vector<std::string> GrowthPath::TakenBack() const {
  std::vector<std::string> words;
  for (const GrowthStep& step : steps)
    if (step.is_kept && !step.takes_back.empty()) words.push_back(step.addition.words);
  return words;
}

std::optional<std::size_t> GrowthPath::TakenBackBy(std::size_t place) const {
  if (!steps[place].is_kept || !steps[place].takes_back.empty()) return std::nullopt;
  for (std::size_t i = place + 1; i < steps.size(); ++i)
    if (steps[i].is_kept && !steps[i].takes_back.empty() && steps[i].addition.words == steps[place].addition.words)
      return NumberOf(i);
  return std::nullopt;
}

std::string GrowthJson(const GrowthPath& path) {
  Json steps = Json::array();
  for (const GrowthStep& step : path.steps) steps.push_back(StepJson(step));
  return JsonText(Json{{"study", path.study},
                       {"state", path.state},
                       {"most_additions", kMostAdditions},
                       {"steps", steps},
                       {"round", RoundJson(path.round)},
                       {"added", path.Added()},
                       {"taken_back", path.TakenBack()},
                       {"end", path.end.empty() ? Json() : Json(path.end)},
                       {"over", path.is_over}});
}

Json GrowthStepsJson(const GrowthPath& path) {
  Json list = Json::array();
  for (std::size_t i = 0; i < path.steps.size(); ++i) {
    const GrowthStep& step = path.steps[i];
    const std::optional<std::size_t> by = path.TakenBackBy(i);
    list.push_back({{"step", path.NumberOf(i)},
                    {"change", step.takes_back.empty() ? "added" : "taken back"},
                    {"what", step.addition.words},
                    {"misfit", NumberOrNull(step.misfit)},
                    {"criterion_change", NumberOrNull(step.criterion)},
                    {"validation_percent", NumberOrNull(step.validation_percent)},
                    {"kept", step.is_kept},
                    {"taken_back_by", by ? Json(*by) : Json()},
                    {"reason", step.reason},
                    {"folder", step.folder}});
  }
  return list;
}

GrowthPath EarlierGrowth(const std::filesystem::path& output, const std::string& state) {
  GrowthPath path;
  try {
    const nlohmann::json json = ReadResultFile(output / "steps" / "growth.json");
    if (TextAt(json, "state") != state) return {};
    path.study = TextAt(json, "study");
    path.state = state;
    for (const nlohmann::json& step : json.at("steps")) path.steps.push_back(StepOf(step));
    path.round = RoundOf(json.at("round"));
    path.end = TextAt(json, "end");
    path.is_over = json.at("over");
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  const auto lost = std::find_if(path.steps.begin(), path.steps.end(),
                                 [&](const GrowthStep& step) { return !IsThere(output, step); });
  const bool is_whole = lost == path.steps.end() && (!path.round || IsThere(output, *path.round));
  path.steps.erase(lost, path.steps.end());
  if (path.steps.empty()) return {};
  // Additions that were refused belong to a round that is known no more.
  if (!is_whole) {
    path.steps.resize(path.LastKept() + 1);
    path.round.reset();
    path.end.clear();
    path.is_over = false;
  }
  return path;
}

std::map<std::string, double> StartsOf(const GrowthOrigin& origin, const GrowthPath& path) {
  std::map<std::string, double> starts;
  const nlohmann::json result = ReadResultFile(origin.RunOf(path.steps.front()) / "result.json");
  for (const nlohmann::json& parameter : ListAt(result, "parameters"))
    starts[TextAt(parameter, "name")] = NumberAt(parameter, "start");
  return starts;
}

}  // namespace fourpost
