#include <cstdio>
#include <string>
#include <vector>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/options.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/inspection/file_kind.h"
#include "identify/run/result_kind.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {

void AddOptions(CLI::App& subcommand, PlanCommand& command) {
  subcommand
      .add_option("RUN", command.run,
                  "Folder that `fourpost fit -o` wrote, or a vehicle file, whose parameters are known by their ranges")
      ->required();
  subcommand.add_option("--rig", command.rig,
                        "What can be measured, how well and in which time (.yaml); without: heave, pitch and roll");
  subcommand.add_option("--time", command.time, "Time on the rig, such as 45min; takes the place of the file's");
  subcommand.add_option("-o,--output", command.output,
                        "Folder for plan.csv, parameters.csv, the motion of the posts in each run, and result.json");
  subcommand
      .add_option("--threads", command.threads,
                  "Runs computed in parallel, without influence on the result; 0: one per processor")
      ->check(CLI::Range(0, 1024));
  subcommand.add_flag("--json", command.json, "Print JSON instead of tables");
}

int Run(const PlanCommand& command) {
  std::error_code failure;
  if (std::filesystem::is_directory(command.run, failure)) RequireFitResult(command.run);
  else RequireVehicleFile(command.run);
  if (!command.rig.empty()) RequireStudyFile(command.rig);
  PlanRequest request = command;
  if (!command.time.empty()) {
    Diagnostics faults;
    request.time_s = ReadQuantity(command.time, kTime, "--time", faults);
    if (!request.time_s) throw FaultyInput(faults);
  }
  if (!command.output.empty()) {
    std::vector<std::filesystem::path> inputs = {command.run / "vehicle.urdf", command.run};
    if (!command.rig.empty()) inputs.push_back(command.rig);
    RequireInputsElsewhere(inputs, command.output);
    RequireNoOtherResult(command.output, ResultKind::kPlan);
    OutputFolder{command.output};
  }
  CatchInterrupts();
  WorkProgress progress;
  const Plan plan = MakePlan(request, progress.Hooks());
  if (plan.is_interrupted) return kInterrupted;
  progress.Tell(plan.findings);
  progress.End();
  const std::string json = JsonText(PlanJson(plan));
  if (!command.output.empty()) {
    OutputFolder output(command.output);
    for (auto& [name, text] : PlanFiles(plan)) output.Add(name, text);
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  if (command.json) Print(json);
  else PrintText(PlanText(plan));
  return plan.design.meets ? kGood : kNotGood;
}

}  // namespace fourpost
