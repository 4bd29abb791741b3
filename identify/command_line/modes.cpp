#include <optional>
#include <stdexcept>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/modes_text.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/results_line.h"
#include "identify/inspection/file_kind.h"
#include "identify/report/modes_page.h"
#include "identify/run/result_kind.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/influence_files.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/pole_files.h"
#include "vehicles/ride/findings.h"
#include "vehicles/ride/stability.h"

namespace fourpost {
namespace {

struct ModesJob {
  Vehicle vehicle;
  std::vector<ParameterRange> ranges;
  Diagnostics findings;
};

ModesJob ReadJob(const ModesCommand& command) {
  RequireVehicleFile(command.model);
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(command.model, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  std::vector<ParameterRange> ranges = ReadParameterRanges(command.vary, *vehicle, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  return {std::move(*vehicle), std::move(ranges), std::move(findings)};
}

std::vector<PolePaths> Trace(const ModesJob& job) {
  std::vector<PolePaths> paths;
  ProgressLine progress;
  try {
    for (const ParameterRange& range : job.ranges) {
      const std::string done = std::to_string(paths.size()) + " of " + std::to_string(job.ranges.size());
      progress.Show("poles: " + done + " parameters; " + job.vehicle.parameters[range.parameter].name);
      paths.push_back(FollowPoles(job.vehicle, range.parameter, range.values));
    }
  } catch (const std::invalid_argument& fault) {
    // Within their bounds, parameters have been checked.
    Refuse(kValuesInconsistent, Place::Option("--vary"), {fault.what()});
  }
  return paths;
}

/// Where a pole crosses the imaginary axis.
void WarnOfGrowth(const Vehicle& vehicle, const std::vector<PolePaths>& paths, Diagnostics& findings) {
  for (const PolePaths& traced : paths) {
    const Parameter& parameter = vehicle.parameters[traced.parameter];
    for (const PolePath& path : traced.paths)
      for (std::size_t i = 0; i < path.pole.size(); ++i) {
        if (!(path.pole[i].real() >= kSlowestMotion_per_s)) continue;
        findings.Report(kModeGrows, Place::Option("--vary"),
                        {path.mode, parameter.name, InUnit(traced.values[i], parameter.unit, 4) + " " + parameter.unit,
                         i + 1 < path.pole.size() ? " and maybe beyond" : ""});
        break;
      }
  }
}

void Write(const std::filesystem::path& folder, const std::string& json, const ModesJob& job,
           const CondensedModel& model, const std::vector<PolePaths>& paths) {
  const Vehicle& vehicle = job.vehicle;
  const bool is_read = !vehicle.sensors.empty() && !vehicle.posts.empty();
  ModesAnswer shown{
      .file = VehicleTextWithValues(vehicle, vehicle.ParameterValues(), std::filesystem::absolute(folder)),
      .impulse = {},
      .influences = {},
      .findings = job.findings};
  OutputFolder output(folder);
  if (is_read) {
    shown.impulse = ImpulseOf(vehicle, model);
    output.Add("impulse.csv", shown.impulse.csv);
    output.Add("impulse.svg", shown.impulse.svg);
  }
  if (!paths.empty()) output.Add("poles.csv", PolesCsv(vehicle, paths));
  for (const PolePaths& traced : paths) {
    const std::string& name = vehicle.parameters[traced.parameter].name;
    shown.influences.push_back({name, PolesSvg(vehicle, traced), is_read ? InfluenceSvg(vehicle, traced) : ""});
    output.Add("poles_" + name + ".svg", shown.influences.back().poles_svg);
    if (is_read) output.Add("bode_" + name + ".svg", shown.influences.back().responses_svg);
  }
  output.Add(kPageName, ModesPage(vehicle, shown));
  output.Add("result.json", json);
  output.Commit();
  PrintResultsLine(folder);
}

}  // namespace

int Run(const ModesCommand& command) {
  ModesJob job = ReadJob(command);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.model}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kModes);
    OutputFolder{command.output};
  }
  const CondensedModel model = CondensedAtValues(job.vehicle);
  if (const std::optional<Growth> growth = GrowthOf(job.vehicle, model))
    job.findings.Report(kUnstableInDesignPose, {job.vehicle.file}, {growth->Text()});
  const std::vector<ShapedMode> modes = ShapedModes(job.vehicle, model);
  const std::vector<PolePaths> paths = Trace(job);
  WarnOfGrowth(job.vehicle, paths, job.findings);
  Tell(job.findings);
  const std::string json = ModesJson(job.vehicle, StateSpace(model), modes, paths, job.findings);
  if (!command.output.empty()) Write(command.output, json, job, model, paths);
  if (command.json) Print(json);
  else PrintText(ModesText(job.vehicle, modes, paths));
  return kGood;
}

}  // namespace fourpost
