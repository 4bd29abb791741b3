#include <stdexcept>
#include <string>

#include "analysis/text/diagnostics.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/inspection/file_kind.h"
#include "vehicles/condensed/condense.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/reduced_json.h"

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

ReducedVehicle Reduced(const Vehicle& vehicle) {
  try {
    return Condense(vehicle);
  } catch (const std::invalid_argument& fault) {
    // The file's own values have been checked against each other.
    Refuse(kValuesInconsistent, Place::Option("--set"), {fault.what()});
  }
}

std::string Summary(const ReducedData& data) {
  TextTable table({data.name, ""});
  const auto add = [&](const char* what, std::size_t count) { table.Add({what, std::to_string(count)}); };
  add("independent coordinates", static_cast<std::size_t>(data.coordinates));
  add("parameters", data.parameters.size());
  add("posts", data.posts.size());
  add("sensors", data.sensors.size());
  add("springs", data.springs);
  add("dampers", data.dampers.size());
  add("tyres", data.tyres.size());
  return table.Format();
}

}  // namespace

int Run(const ExportCommand& command) {
  const std::filesystem::path file = VehicleFile(command.input);
  RequireWritable(command.output, {file});
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(file, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  Tell(findings);
  const ReducedVehicle reduced = Reduced(*vehicle);
  if (!command.output.empty()) WriteFile(command.output, ReducedJson(reduced));
  if (command.json) Print(ReducedJson(reduced));
  else PrintText(Summary(reduced.data()));
  return kGood;
}

}  // namespace fourpost
