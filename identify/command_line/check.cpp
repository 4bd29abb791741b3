#include <nlohmann/json.hpp>

#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/command_line/text_table.h"
#include "vehicles/vehicle_file.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// A free motion has a double pole at zero, which rounding moves by the root of 1e-16 times some 100 / s.
constexpr double kNoGrowth_per_s = 1e-4;

bool IsStable(const VehicleSummary& summary) { return summary.growth_rate < kNoGrowth_per_s; }

/// What is odd about the vehicle, for stderr.
void Warn(const Vehicle& vehicle, const VehicleSummary& summary) {
  Diagnostics odd;
  if (!IsStable(summary))
    odd.Warning(vehicle.file, 0,
                "the vehicle is unstable in its design pose: a motion grows by exp(" + Rounded(summary.growth_rate, 3) +
                    " t); check positions, axes and rates");
  const std::size_t missing =
      static_cast<std::size_t>(summary.dof) - std::min(summary.modes.size(), static_cast<std::size_t>(summary.dof));
  if (missing > 0)
    odd.Warning(vehicle.file, 0,
                std::to_string(missing) + " of " + std::to_string(summary.dof) +
                    " motions do not oscillate: overdamped, or held by no spring");
  Tell(odd);
}

std::string AsJson(const Vehicle& vehicle, const VehicleSummary& summary) {
  Json loads = Json::array();
  for (const auto& load : summary.corner_loads) loads.push_back({{"name", load.tyre}, {"load_N", load.load_N}});
  Json modes = Json::array();
  for (const Mode& mode : summary.modes)
    modes.push_back({{"frequency_Hz", mode.frequency_Hz}, {"damping_ratio", mode.damping_ratio}, {"name", mode.name}});
  Json parameters = Json::array();
  for (const Parameter& parameter : vehicle.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"value", parameter.value},
                          {"unit", SiUnit(parameter.dimension)},
                          {"lower", parameter.lower},
                          {"upper", parameter.upper},
                          {"source", parameter.source}});
  const Json json = {{"name", vehicle.name},        {"dof", summary.dof},
                     {"mass", summary.mass_kg},     {"com", {summary.com.x(), summary.com.y(), summary.com.z()}},
                     {"corner_loads", loads},       {"modes", modes},
                     {"stable", IsStable(summary)}, {"parameters", parameters}};
  return json.dump(2) + '\n';
}

std::string Range(const Parameter& parameter) {
  if (!(parameter.upper > parameter.lower)) return "fixed";
  return FormatQuantity(parameter.lower, parameter.unit) + " .. " + FormatQuantity(parameter.upper, parameter.unit);
}

std::string AsText(const Vehicle& vehicle, const VehicleSummary& summary) {
  std::string text = vehicle.name + ": " + std::to_string(summary.dof) + " degrees of freedom, " +
                     Rounded(summary.mass_kg, 5) + " kg, centre of mass at x " + Rounded(summary.com.x(), 4) +
                     " m, y " + Rounded(summary.com.y(), 4) + " m, z " + Rounded(summary.com.z(), 4) + " m\n\n";
  TextTable loads({"tyre", "static load, N"});
  for (const auto& load : summary.corner_loads) loads.Add({load.tyre, Rounded(load.load_N, 5)});
  TextTable modes({"mode", "Hz", "damping ratio"});
  for (const Mode& mode : summary.modes)
    modes.Add({mode.name, Rounded(mode.frequency_Hz, 4), Rounded(mode.damping_ratio, 3)});
  TextTable parameters({"parameter", "value", "unit", "range", "source"});
  for (const Parameter& parameter : vehicle.parameters)
    parameters.Add({parameter.name, InUnit(parameter.value, parameter.unit, 5), parameter.unit, Range(parameter),
                    parameter.source});
  return text + loads.Format() + '\n' + modes.Format() + '\n' + parameters.Format();
}

}  // namespace

int Run(const CheckCommand& command) {
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = ReadVehicle(command.model, diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  Tell(diagnostics);
  const VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
  Warn(*vehicle, summary);
  Print(command.json ? AsJson(*vehicle, summary) : AsText(*vehicle, summary));
  return kGood;
}

}  // namespace fourpost
