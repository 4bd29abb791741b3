#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/inspection/file_kind.h"
#include "identify/report/vehicle_page.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep.h"

namespace fourpost {
namespace {

/// Of a run the fitted vehicle.
std::filesystem::path VehicleFile(const std::filesystem::path& input) {
  if (!std::filesystem::is_directory(input)) {
    RequireVehicleFile(input);
    return input;
  }
  RequireFitResult(input);
  return input / "vehicle.urdf";
}

/// By harmonic balance of the reduced model, as the page's sliders do.
std::vector<SweptResponse> Respond(const Vehicle& vehicle, const SweepRequest& request) {
  CatchInterrupts();
  SteadySolver solver(vehicle);
  RequireStable(vehicle, solver);
  WorkProgress progress;
  std::vector<SweptResponse> responses;
  for (const Sweep& sweep : request.sweeps) {
    std::optional<SteadyResponse> answer =
        SolveSweep(solver, sweep.mode, sweep.excitation, Engine::kReduced, {}, progress.Hooks());
    if (answer) responses.push_back(Sorted(sweep, std::move(*answer), request.channels));
    if (Interrupted()) break;
  }
  return responses;
}

}  // namespace

int Run(const ViewCommand& command) {
  const std::filesystem::path file = VehicleFile(command.input);
  const std::filesystem::path page =
      command.output.empty() ? std::filesystem::path(command.input.stem()).concat(".html") : command.output;
  RequireWritable(page, {file});
  RequireEnding("--output", page, "a page", ".html");
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(file, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  const std::optional<SweepRequest> request = ReadSweep(command.sweep, *vehicle, findings);
  if (findings.HasErrors() || !request) throw FaultyInput(findings);
  CondensedAtValues(*vehicle);
  Tell(findings);
  const std::vector<SweptResponse> responses = Respond(*vehicle, *request);
  if (Interrupted()) return kInterrupted;
  // At the values of --set, for what the page saves begins with it.
  const std::string saved =
      VehicleTextWithValues(*vehicle, vehicle->ParameterValues(), std::filesystem::absolute(page).parent_path());
  const std::string text =
      VehiclePage(*vehicle, {.facts = {"not fitted"}, .file = saved, .findings = findings, .responses = responses});
  ReplaceFile(page, text);
  if (command.json) Print(JsonText(nlohmann::ordered_json{{"file", page.string()}, {"bytes", text.size()}}));
  else Print(page.string() + '\n');
  return kGood;
}

}  // namespace fourpost
