#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "analysis/files/recorded_table.h"
#include "identify/command_line/added_load.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/run/findings.h"
#include "identify/run/result_kind.h"
#include "identify/run/run_spread.h"
#include "identify/study/fitted_files.h"
#include "identify/study/loaded_study.h"
#include "identify/study/study.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// A fit's vehicle, and the study that it was fitted by.
struct FittedRun {
  Vehicle vehicle;
  Study study;
  /// Whether the recording that is to be predicted was fitted.
  bool has_seen = false;
  /// Already on `vehicle`.
  std::optional<AddedLoad> load = {};
};

/// Throws FaultyInput.
FittedRun LoadModel(const std::filesystem::path& run) {
  // It names the recordings that were fitted.
  RequireFitResult(run);
  for (const char* name : {"vehicle.urdf", "study.yaml"})
    if (std::error_code failure; !std::filesystem::exists(run / name, failure))
      Refuse(kRunFileMissing, {run.string()}, {name});
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicle(run / "vehicle.urdf", diagnostics);
  std::optional<Study> study = ReadStudy(run / "study.yaml", diagnostics);
  if (!vehicle || !study) throw FaultyInput(diagnostics);
  return {.vehicle = std::move(*vehicle), .study = std::move(*study)};
}

/// The experiment of the study that the recording is one more of. Throws FaultyInput.
const Experiment& ExperimentOf(const std::filesystem::path& recording, const Study& study) {
  Diagnostics diagnostics;
  const std::optional<RecordedTable> table = ReadRecordedTable(recording, diagnostics);
  if (!table) throw FaultyInput(diagnostics);
  // Later kinds are more special: a history is one of stepped sines only where the study has no histories.
  const Experiment* last = nullptr;
  for (const Experiment& experiment : study.experiments)
    if (experiment.Reads(*table)) last = &experiment;
  if (last != nullptr) return *last;
  std::string kinds;
  for (const Experiment& experiment : study.experiments)
    if (!experiment.Recordings().empty()) kinds += (kinds.empty() ? "" : "; ") + std::string(experiment.Recordings());
  Refuse(kRecordingOfOtherKind, {recording.string()}, {kinds});
}

std::string AsJson(const PredictCommand& command, const FittedRun& model, const ExperimentResults& results) {
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json json = {{"vehicle", model.vehicle.name},
               {"recording", command.recording.filename().string()},
               {"was_fitted", model.has_seen}};
  if (model.load) json["added_load"] = AddedLoadJson(*model.load);
  json.update(results.json);
  json.update({{"warnings", WarningsJson(results.findings)}, {"versions", versions}});
  return JsonText(json);
}

std::string LoadText(const FittedRun& model) { return model.load ? AddedLoadText(*model.load) + '\n' : ""; }

/// Nothing where it was interrupted.
std::optional<ExperimentResults> Predict(const PredictCommand& command, const FittedRun& model,
                                         WorkProgress& progress) {
  const std::vector<std::size_t> free;
  Subject subject(model.vehicle, free, command.run / "study.yaml");
  subject.FollowControl(ControlOf(model.study, model.vehicle));
  const Experiment& experiment = ExperimentOf(command.recording, model.study);
  std::optional<RunSpread> spread;
  if (HasRunSpread(command.run)) spread = ReadRunSpread(command.run);
  CatchInterrupts();
  std::optional<ExperimentResults> results = experiment.Predict(subject,
                                                                {.recording = command.recording,
                                                                 .run = command.run,
                                                                 .engine = command.engine,
                                                                 .mode = command.mode,
                                                                 .has_kalman = command.kalman,
                                                                 .noise_from = command.noise_from,
                                                                 .spread = spread ? &spread->parameters : nullptr,
                                                                 .setting = command.setting,
                                                                 .has_files = !command.output.empty()},
                                                                progress.Hooks());
  if (results && spread && results->json.contains("band_95") && !spread->Held().empty())
    results->findings.Report(kBandsWithoutParameters, {command.run.string()}, {spread->HeldText()});
  return results;
}

}  // namespace

int Run(const PredictCommand& command) {
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.run / "vehicle.urdf", command.recording}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kPrediction);
    OutputFolder{command.output};
  }
  FittedRun model = LoadModel(command.run);
  model.has_seen = WasFitted(command.run / "result.json", command.recording);
  if (model.has_seen) Tell(kRecordingWasFitted, {command.recording.string()});
  if (!command.add_mass.empty()) model.load = AddLoad(command.add_mass, command.at, model.vehicle);
  WorkProgress progress;
  const std::optional<ExperimentResults> results = Predict(command, model, progress);
  if (!results) return kInterrupted;
  progress.Tell(results->findings);
  progress.End();
  const std::string json = AsJson(command, model, *results);
  if (!command.output.empty()) {
    OutputFolder output(command.output);
    for (const auto& [name, text] : results->files) output.Add(name, text);
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  if (command.json) Print(json);
  else PrintText(LoadText(model) + results->text);
  return kGood;
}

}  // namespace fourpost
