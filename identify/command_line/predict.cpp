#include <cstdio>
#include <optional>
#include <string>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/added_load.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/run/result_kind.h"
#include "identify/run/run_prediction.h"
#include "identify/study/fitted_files.h"

namespace fourpost {
namespace {

PredictionRequest RequestOf(const PredictCommand& command) {
  return {.recording = command.recording,
          .engine = command.engine,
          .mode = command.mode,
          .has_kalman = command.kalman,
          .noise_from = command.noise_from,
          .setting = command.setting,
          .release = command.release,
          .start_s = command.start_s,
          .has_files = !command.output.empty()};
}

}  // namespace

int Run(const PredictCommand& command) {
  if (command.faults.HasErrors()) throw FaultyInput(command.faults);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.run / "vehicle.urdf", command.recording}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kPrediction);
    OutputFolder{command.output};
  }
  // It names the recordings that were fitted.
  RequireFitResult(command.run);
  FittedRun run = LoadFittedRun(command.run);
  if (WasFitted(command.run / "result.json", command.recording))
    Tell(kRecordingWasFitted, {command.recording.string()});
  std::optional<AddedLoad> load;
  if (!command.add_mass.empty()) load = AddLoad(command.add_mass, command.at, run.vehicle);
  WorkProgress progress;
  CatchInterrupts();
  const std::optional<ExperimentResults> results = PredictRecording(run, RequestOf(command), progress.Hooks());
  if (!results) return kInterrupted;
  progress.Tell(results->findings);
  progress.End();
  nlohmann::ordered_json beside = nlohmann::ordered_json::object();
  if (load) beside["added_load"] = AddedLoadJson(*load);
  const std::string json = PredictionJson(run, command.recording, beside, *results);
  if (!command.output.empty()) {
    OutputFolder output(command.output);
    for (const auto& [name, text] : results->files) output.Add(name, text);
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.c_str());
  }
  if (command.json) Print(json);
  else PrintText((load ? AddedLoadText(*load) + '\n' : "") + results->text);
  return kGood;
}

}  // namespace fourpost
