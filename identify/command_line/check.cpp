#include <filesystem>

#include "identify/command_line/check_json.h"
#include "identify/command_line/check_text.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/print.h"
#include "identify/command_line/text_table.h"
#include "vehicles/mobility.h"
#include "vehicles/resolved_text.h"
#include "vehicles/vehicle_file.h"
#include "vehicles/vehicle_lint.h"
#include "vehicles/vehicle_summary.h"

namespace fourpost {
namespace {

Diagnostics Instability(const Vehicle& vehicle, const VehicleSummary& summary) {
  Diagnostics odd;
  if (!summary.IsStable())
    odd.Warning(vehicle.file, 0,
                "the vehicle is unstable in its design pose: a motion grows by exp(" + Rounded(summary.growth_rate, 3) +
                    " t); check positions, axes and rates");
  return odd;
}

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
  const Mobility mobility = MobilityOf(*vehicle);
  const VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
  Tell(Instability(*vehicle, summary));
  Tell(Lint(*vehicle));
  Print(command.json ? CheckJson(*vehicle, summary, mobility) : CheckText(*vehicle, summary, mobility));
  return kGood;
}

}  // namespace fourpost
