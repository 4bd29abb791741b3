#include "identify/suggest/suggestion_json.h"

#include <optional>
#include <vector>

#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// SI units of the parameters that a suggestion adds or frees.
std::vector<std::string> AddedUnits(const SuggestedAddition& suggestion, const LoadedStudy& study) {
  Vehicle vehicle = study.vehicle;
  Diagnostics findings;
  if (!suggestion.addition.vehicle.empty())
    if (auto read = ReadVehicleText(suggestion.addition.vehicle, study.vehicle.file, findings)) vehicle = *read;
  std::vector<std::string> units;
  for (const std::string& name : suggestion.addition.parameters)
    for (const Parameter& parameter : vehicle.parameters)
      if (parameter.name == name) units.push_back(SiUnit(parameter.dimension));
  return units;
}

}  // namespace

std::string ExpectedText(const SuggestedAddition& suggestion, const LoadedStudy& study) {
  if (suggestion.addition.study) {
    const bool is_most = suggestion.amount >= suggestion.addition.greatest;
    const bool is_least = suggestion.amount <= suggestion.addition.least;
    return (suggestion.addition.mechanism == "delay" ? Rounded(1e3 * suggestion.amount, 3) + " ms"
                                                     : "times " + Rounded(1 + suggestion.amount, 4)) +
           (is_most    ? " or more"
            : is_least ? " or less"
                       : "");
  }
  const std::vector<std::string> units = AddedUnits(suggestion, study);
  std::string text;
  for (std::size_t i = 0; i < suggestion.values.size(); ++i)
    text += (text.empty() ? "" : ", ") + Rounded(suggestion.values[i], 3) + (units[i] == "1" ? "" : ' ' + units[i]);
  return text;
}

Json SuggestionJson(const SuggestedAddition& one, std::size_t number, const LoadedStudy& study) {
  const std::vector<std::string> units = AddedUnits(one, study);
  Json parameters = Json::array();
  for (std::size_t i = 0; i < one.values.size(); ++i)
    parameters.push_back({{"name", one.addition.parameters[i]}, {"unit", units[i]}, {"value", one.values[i]}});
  Json moved = Json::array();
  for (const MovedParameter& parameter : one.moved)
    moved.push_back({{"name", parameter.name}, {"percent", 100 * parameter.share}});
  Json like = Json::array();
  for (const std::size_t k : one.like) like.push_back(k + 1);
  return {{"number", number},
          {"mechanism", one.addition.mechanism},
          {"elements", one.addition.elements},
          {"text", one.addition.words},
          {"expected", ExpectedText(one, study)},
          {"lowers_bic", one.criterion < 0},
          {"parameters", parameters},
          {"correction", one.addition.study ? Json(one.amount) : Json(nullptr)},
          {"cost", one.cost},
          {"fall_percent", 100 * one.fall},
          {"criterion_change", one.criterion},
          {"moves", moved},
          {"like", like}};
}

}  // namespace fourpost
