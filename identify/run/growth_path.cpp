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

Json StepJson(const GrowthStep& step) {
  return {{"added", step.added},
          {"mechanism", step.mechanism},
          {"elements", step.elements},
          {"folder", step.folder},
          {"cost", NumberOrNull(step.cost)},
          {"misfit", NumberOrNull(step.misfit)},
          {"criterion_change", NumberOrNull(step.criterion)},
          {"validation_percent", NumberOrNull(step.validation_percent)},
          {"at_bound", step.at_bound},
          {"kept", step.is_kept},
          {"reason", step.reason}};
}

/// Throws where it is not one.
GrowthStep StepOf(const nlohmann::json& json) {
  return {.added = json.at("added"),
          .mechanism = json.at("mechanism"),
          .elements = json.at("elements"),
          .folder = json.at("folder"),
          .cost = NumberAt(json, "cost"),
          .misfit = NumberAt(json, "misfit"),
          .criterion = NumberAt(json, "criterion_change"),
          .validation_percent = NumberAt(json, "validation_percent"),
          .at_bound = json.at("at_bound"),
          .is_kept = json.at("kept"),
          .reason = json.at("reason")};
}

Json RoundJson(const std::optional<GrowthRound>& round) {
  if (!round) return nullptr;
  Json candidates = Json::array();
  for (const GrowthCandidate& one : round->candidates)
    candidates.push_back({{"added", one.added},
                          {"mechanism", one.mechanism},
                          {"elements", one.elements},
                          {"folder", one.folder},
                          {"effective_residuals", one.effective},
                          {"count", one.count},
                          {"parameters", one.parameters}});
  return {{"residuals", round->residuals}, {"tried", round->additions}, {"candidates", candidates}};
}

std::optional<GrowthRound> RoundOf(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  GrowthRound round{.residuals = json.at("residuals"), .additions = json.at("tried")};
  for (const nlohmann::json& one : json.at("candidates"))
    round.candidates.push_back({.added = one.at("added"),
                                .mechanism = one.at("mechanism"),
                                .elements = one.at("elements"),
                                .folder = one.at("folder"),
                                .effective = one.at("effective_residuals"),
                                .count = one.at("count"),
                                .parameters = one.at("parameters")});
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

std::vector<std::string> GrowthPath::Added() const {
  std::vector<std::string> words;
  for (const GrowthStep& step : steps)
    if (step.is_kept && !step.added.empty()) words.push_back(step.added);
  return words;
}

std::string GrowthJson(const GrowthPath& path) {
  Json steps = Json::array();
  for (const GrowthStep& step : path.steps) steps.push_back(StepJson(step));
  return JsonText(Json{{"study", path.study},
                       {"state", path.state},
                       {"most_additions", kMostAdditions},
                       {"steps", steps},
                       {"round", RoundJson(path.round)},
                       {"end", path.end.empty() ? Json() : Json(path.end)},
                       {"over", path.is_over}});
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
    path.is_over = false;
  }
  if (!path.is_over) path.end.clear();
  return path;
}

}  // namespace fourpost
