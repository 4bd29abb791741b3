#include <filesystem>
#include <optional>
#include <utility>

#include "analysis/text/text_table.h"
#include "identify/command_line/check_json.h"
#include "identify/command_line/check_text.h"
#include "identify/command_line/checked_vehicle.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "vehicles/lint/ride_lint.h"
#include "vehicles/lint/vehicle_lint.h"
#include "vehicles/loops/mobility.h"
#include "vehicles/reader/resolved_text.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {
namespace {

void Append(const Diagnostics& more, Diagnostics& findings) {
  for (const Diagnostic& item : more.items()) findings.Add(item);
}

/// Adds all that can be found in the file; nothing where an error keeps the vehicle from being checked.
std::optional<CheckedVehicle> Checked(const CheckCommand& command, Diagnostics& findings) {
  std::optional<Vehicle> vehicle = ReadVehicle(command.model, findings);
  if (!vehicle) return std::nullopt;
  SetParameters(command.set, *vehicle, findings);
  if (findings.HasErrors()) return std::nullopt;
  Append(LintDescription(*vehicle), findings);
  try {
    Mobility mobility = MobilityOf(*vehicle);
    VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
    Append(LintRide(*vehicle, summary), findings);
    Append(LintAssembled(*vehicle), findings);
    return CheckedVehicle{std::move(*vehicle), std::move(mobility), std::move(summary)};
  } catch (const FaultyInput& fault) {
    Append(fault.diagnostics(), findings);
    return std::nullopt;
  }
}

int PrintResolved(const std::filesystem::path& file) {
  Diagnostics findings;
  const std::optional<Vehicle> vehicle = ReadVehicle(file, findings);
  if (!vehicle) throw FaultyInput(findings);
  Tell(findings);
  Print(ResolvedText(*vehicle, std::filesystem::current_path()));
  return kGood;
}

}  // namespace

int Run(const CheckCommand& command) {
  if (command.resolved) return PrintResolved(command.model);
  Diagnostics findings;
  const std::optional<CheckedVehicle> checked = Checked(command, findings);
  if (command.json) Print(CheckJson(checked, findings));
  if (!checked) throw FaultyInput(findings);
  Tell(findings);
  if (!command.json) PrintText(CheckText(*checked));
  return kGood;
}

}  // namespace fourpost
