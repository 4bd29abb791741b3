#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "vehicles/reader/parameter_uses.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

bool HasRange(const Parameter& parameter) { return parameter.lower < parameter.upper; }

std::string RangeText(const Parameter& parameter) {
  if (!HasRange(parameter)) return "fixed";
  return InUnit(parameter.lower, parameter.unit, 4) + " .. " + InUnit(parameter.upper, parameter.unit, 4);
}

/// "+- 20", "like c_1, to 0.7 of the logarithm"
std::string Prior(const Parameter& parameter) {
  std::string text = parameter.prior_sd ? "+- " + InUnit(*parameter.prior_sd, parameter.unit, 3) : "";
  if (parameter.like)
    text += (text.empty() ? "like " : ", like ") + parameter.like->parameter + ", to " +
            Rounded(parameter.like->sd, 3) + " of the logarithm";
  return text;
}

std::string Text(const Vehicle& vehicle, const std::vector<ParameterUse>& uses) {
  TextTable table({"parameter", "value", "unit", "range", "prior", "used by"});
  for (const Parameter& parameter : vehicle.parameters) {
    std::vector<std::string> row = {parameter.name, InUnit(parameter.value, parameter.unit, 6), parameter.unit,
                                    RangeText(parameter), Prior(parameter)};
    bool used = false;
    for (const ParameterUse& use : uses) {
      if (use.parameter != parameter.name) continue;
      row.push_back(use.what + ", line " + std::to_string(use.line));
      table.Add(row);
      // Further uses stand below the first.
      row.assign(row.size() - 1, "");
      used = true;
    }
    if (used) continue;
    row.emplace_back("nothing");
    table.Add(row);
  }
  return table.Format();
}

std::string ParamsJson(const Vehicle& vehicle, const std::vector<ParameterUse>& uses) {
  const auto or_null = [](bool is_there, double value) { return is_there ? Json(value) : Json(); };
  Json parameters = Json::array();
  for (const Parameter& parameter : vehicle.parameters) {
    Json used = Json::array();
    for (const ParameterUse& use : uses)
      if (use.parameter == parameter.name) used.push_back({{"what", use.what}, {"line", use.line}});
    parameters.push_back({{"name", parameter.name},
                          {"value", parameter.value},
                          {"unit", SiUnit(parameter.dimension)},
                          {"file_unit", parameter.unit},
                          {"lower", or_null(HasRange(parameter), parameter.lower)},
                          {"upper", or_null(HasRange(parameter), parameter.upper)},
                          {"precision", or_null(HasRange(parameter), parameter.precision)},
                          {"prior_sd", or_null(parameter.prior_sd.has_value(), parameter.prior_sd.value_or(0))},
                          {"source", parameter.source},
                          {"used_by", used}});
    if (parameter.like)
      parameters.back()["like"] = {{"parameter", parameter.like->parameter}, {"sd", parameter.like->sd}};
  }
  const Json json = {{"file", vehicle.file}, {"name", vehicle.name}, {"parameters", parameters}};
  return JsonText(json);
}

}  // namespace

int Run(const ParamsCommand& command) {
  Diagnostics findings;
  const std::optional<Vehicle> vehicle = ReadVehicle(command.model, findings);
  if (!vehicle) throw FaultyInput(findings);
  Tell(findings);
  const std::vector<ParameterUse> uses = FindParameterUses(vehicle->text);
  if (command.json) Print(ParamsJson(*vehicle, uses));
  else PrintText(Text(*vehicle, uses));
  return kGood;
}

}  // namespace fourpost
