#include <filesystem>

#include "identify/command_line/check_json.h"
#include "identify/command_line/check_text.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/command_line/text_table.h"
#include "vehicles/resolved_text.h"
#include "vehicles/vehicle_file.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {
namespace {

std::string FreeMotions(const VehicleSummary& summary) {
  std::string names;
  for (const Mode& mode : summary.modes)
    if (mode.kind == Mode::Kind::kFree) names += (names.empty() ? "" : ", ") + mode.name;
  return names;
}

/// What is odd about the vehicle.
Diagnostics Oddities(const Vehicle& vehicle, const VehicleSummary& summary) {
  Diagnostics odd;
  const auto warn = [&](const std::string& message) { odd.Warning(vehicle.file, 0, message); };
  if (!summary.IsStable())
    warn("the vehicle is unstable in its design pose: a motion grows by exp(" + Rounded(summary.growth_rate, 3) +
         " t); check positions, axes and rates");
  if (const std::string names = FreeMotions(summary); !names.empty()) warn("held by no spring: " + names);
  // The digits that are printed.
  constexpr double kAgree = 1e-4;
  const double weight = summary.Weight_N();
  if (!vehicle.tyres.empty() && std::abs(summary.TyreLoad_N() - weight) > kAgree * weight)
    warn("the tyres carry " + Rounded(summary.TyreLoad_N(), 5) + " N, but the vehicle weighs " + Rounded(weight, 5) +
         " N: joints or springs to the ground carry the rest");
  return odd;
}

/// A line on how the freedoms are counted.
std::string Mobility(const Vehicle&) { return ""; }

}  // namespace

int Run(const CheckCommand& command) {
  Diagnostics diagnostics;
  const std::optional<Vehicle> vehicle = ReadVehicle(command.model, diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  Tell(diagnostics);
  if (command.resolved) {
    Print(ResolvedText(*vehicle, std::filesystem::current_path()));
    return kGood;
  }
  const VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
  Tell(Oddities(*vehicle, summary));
  Print(command.json ? CheckJson(*vehicle, summary) : CheckText(*vehicle, summary, Mobility(*vehicle)));
  return kGood;
}

}  // namespace fourpost
