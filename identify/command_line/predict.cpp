#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "analysis/recorded_table.h"
#include "analysis/time_recording.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/engine_text.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/history_table.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/measured_channels.h"
#include "identify/command_line/predictions.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/result_kind.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/text_table.h"
#include "identify/fitted_files.h"
#include "identify/history_files.h"
#include "identify/history_fit_files.h"
#include "identify/history_misfit_json.h"
#include "identify/history_residuals.h"
#include "identify/json_text.h"
#include "identify/kalman_noise_json.h"
#include "identify/lint/history_remark.h"
#include "identify/lint/remedied_error.h"
#include "identify/lint/tyre_pull_lint.h"
#include "identify/study.h"
#include "identify/versions.h"
#include "identify/warning_texts.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void Refuse(const std::filesystem::path& file, const std::string& message) {
  Diagnostics faults;
  faults.Error(file.string(), 0, message);
  throw FaultyInput(faults);
}

/// An option that the recording has no use for. Throws FaultyInput.
void RequireUnused(const char* option, bool is_used, const std::filesystem::path& recording, const std::string& why) {
  if (!is_used) return;
  Diagnostics faults;
  faults.Error(option, 0, recording.filename().string() + ' ' + why + "; leave the option out");
  throw FaultyInput(faults);
}

/// Throws FaultyInput.
FittedRun LoadModel(const std::filesystem::path& run) {
  // It tells which recordings the fit has seen.
  RequireFitResult(run);
  for (const char* name : {"vehicle.urdf", "study.yaml"})
    if (std::error_code failure; !std::filesystem::exists(run / name, failure))
      Refuse(run, std::string("holds no ") + name + ", which a fit writes; run `fourpost fit` with -o on it again");
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicle(run / "vehicle.urdf", diagnostics);
  std::optional<Study> study = ReadStudy(run / "study.yaml", diagnostics);
  if (!vehicle || !study) throw FaultyInput(diagnostics);
  return {.vehicle = std::move(*vehicle), .study = std::move(*study)};
}

enum class RecordingKind { kTime, kFrequency };

/// By its columns; a study may name that of times. Throws FaultyInput.
RecordingKind KindOf(const std::filesystem::path& recording, const Study& study) {
  Diagnostics diagnostics;
  const std::optional<RecordedTable> table = ReadRecordedTable(recording, diagnostics);
  if (!table) throw FaultyInput(diagnostics);
  if (table->FindColumn("frequency_Hz")) return RecordingKind::kFrequency;
  std::vector<std::string> times = kTimeColumn.names;
  for (const StudyHistory& history : study.histories)
    if (history.time) times.push_back(history.time->name);
  for (const std::string& name : times)
    if (table->FindColumn(name)) return RecordingKind::kTime;
  Refuse(recording, "has neither a column 'time' nor 'frequency_Hz': it is no recording");
}

/// The first of the study's histories, of this recording.
StudyHistory Layout(const Study& study, const std::filesystem::path& recording) {
  if (study.histories.empty())
    Refuse(recording,
           "is a recording over time, but the model was fitted to none: nothing tells which channels are its "
           "posts and sensors");
  StudyHistory history = study.histories.front();
  history.file = recording;
  history.name = recording.stem().string();
  history.end_s.reset();
  Diagnostics diagnostics;
  const std::optional<RecordedTable> table = ReadRecordedTable(recording, diagnostics);
  if (!table) throw FaultyInput(diagnostics);
  KeepMeasured(recording, table->names(), history.channels);
  return history;
}

/// Throws FaultyInput.
MeasuredHistory Load(const PredictCommand& command, const FittedRun& model, const StudyHistory& layout,
                     Diagnostics& diagnostics) {
  const std::optional<std::vector<MeasuredHistory>> histories =
      LoadHistories({layout}, (command.run / "study.yaml").string(), model.vehicle, diagnostics);
  if (!histories) throw FaultyInput(diagnostics);
  return histories->front();
}

/// As recorded: a Kalman filter takes no filter back.
MeasuredHistory LoadAsRecorded(const PredictCommand& command, const FittedRun& model,
                               const std::filesystem::path& recording, std::optional<double> end_s) {
  StudyHistory layout = Layout(model.study, recording);
  layout.filter.reset();
  layout.end_s = end_s;
  // Told of the recording with its filter.
  Diagnostics findings;
  return Load(command, model, layout, findings);
}

/// Never of the recording that is judged. Throws FaultyInput.
KalmanNoise NoiseOf(const PredictCommand& command, const FittedRun& model, const MeasuredHistory& judged) {
  if (command.noise_from.empty()) {
    const std::optional<KalmanNoise> told = ReadKalmanNoise(command.run / "result.json", judged);
    if (told) return *told;
    Refuse(command.run,
           "tells no noise for a Kalman filter, for the fit was not by 'cost: prediction': name the "
           "recording it was fitted to by --noise-from, for noise estimated on the recording that is "
           "judged would flatter the model");
  }
  const MeasuredHistory history = LoadAsRecorded(command, model, command.noise_from, std::nullopt);
  ProgressLine line;
  return KalmanPredictor(history).Estimate(CondensedVehicle(model.vehicle).At(model.vehicle.ParameterValues()),
                                           {.progress = [&line](int runs) {
                                             line.Show("noise of the Kalman filter: " + std::to_string(runs) +
                                                       " runs of it" + Rate(runs, line.seconds(), "runs"));
                                           }});
}

void AddKalman(const PredictCommand& command, const FittedRun& model, const MeasuredHistory& judged,
               std::vector<HistoryMisfit>& misfits) {
  for (const Damper& damper : model.vehicle.dampers)
    if (damper.hydraulic)
      Refuse(command.run / "vehicle.urdf", "fp:damper '" + damper.name +
                                               "' is hydraulic: a Kalman filter corrects positions and velocities, and "
                                               "knows nothing of its oil; leave --kalman out");
  const MeasuredHistory recorded =
      LoadAsRecorded(command, model, command.recording, judged.TimeAt(judged.count - 1) + 0.5 / judged.rate_Hz);
  const KalmanPrediction prediction = KalmanPredictor(recorded).Run(
      CondensedVehicle(model.vehicle).At(model.vehicle.ParameterValues()), NoiseOf(command, model, recorded));
  AddOneStepErrors({recorded}, {prediction}, misfits);
}

/// Nothing where it is interrupted.
std::optional<EngineHistory> Answer(const PredictCommand& command, const FittedRun& model,
                                    const MeasuredHistory& history) {
  CatchInterrupts();
  ProgressLine line;
  const double end = history.TimeAt(history.count - 1);
  return SimulateBy({.engine = command.engine.value_or(Engine::kAuto)}, history, model.vehicle,
                    model.vehicle.ParameterValues(), [&](const std::string& work, double t) {
                      line.Show(work + ": " + Rounded(t, 3) + " of " + Rounded(end, 3) + " s");
                      return !Interrupted();
                    });
}

std::string AsJson(const PredictCommand& command, const FittedRun& model, const MeasuredHistory& history,
                   const HistoryEngine& by, const std::vector<HistoryMisfit>& misfits,
                   const std::vector<std::string>& warnings) {
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  Json json = {{"vehicle", model.vehicle.name},
               {"recording", command.recording.filename().string()},
               {"was_fitted", model.has_seen}};
  if (model.load) json["added_load"] = AddedLoadJson(*model.load);
  json.update(EngineJson(by, HistorySolver::Options{}.error));
  json.update({{"start_s", history.TimeAt(0)},
               {"end_s", history.TimeAt(history.count - 1)},
               {"samples", history.count},
               {"channels", HistoryMisfitsJson(misfits)},
               {"warnings", warnings},
               {"versions", versions}});
  return JsonText(json);
}

/// On a channel that is late, turned, of another unit or swapped.
std::vector<std::string> Remarks(const std::vector<MeasuredHistory>& histories,
                                 const std::vector<Eigen::MatrixXd>& modelled,
                                 const std::vector<HistoryMisfit>& misfits) {
  std::vector<std::string> texts;
  for (const HistoryRemark& remark :
       RemarksOn(misfits, 1 / histories.front().rate_Hz, RemediedErrors(histories, modelled)))
    texts.push_back(remark.message);
  return texts;
}

int PredictHistory(const PredictCommand& command, const FittedRun& model) {
  Diagnostics findings;
  const std::vector<MeasuredHistory> histories = {
      Load(command, model, Layout(model.study, command.recording), findings)};
  const MeasuredHistory& history = histories.front();
  const HistoryResiduals reduced(std::make_shared<const CondensedVehicle>(model.vehicle), histories, {});
  const std::vector<double> values = model.vehicle.ParameterValues();
  LintTyrePulls(model.vehicle, values, histories, reduced.Steps(), findings);
  Tell(findings);
  const std::optional<EngineHistory> answer = Answer(command, model, history);
  if (!answer) return kInterrupted;
  const std::vector<Eigen::MatrixXd> modelled = {answer->modelled};
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (answer->by.engine == Engine::kFull) AddReducedErrors(history, reduced.Modelled(values).front(), misfits);
  if (command.kalman) AddKalman(command, model, history, misfits);
  if (Interrupted()) return kInterrupted;
  const std::vector<std::string> remarks = Remarks(histories, modelled, misfits);
  std::vector<std::string> warnings = WarningTexts(findings);
  warnings.insert(warnings.end(), remarks.begin(), remarks.end());
  const std::string json = AsJson(command, model, history, answer->by, misfits, warnings);
  if (!command.output.empty()) {
    OutputFolder output(command.output);
    output.Add("history.csv", HistoryFitCsv(histories, modelled));
    output.Add("history.svg", HistoryFitSvg(history, modelled.front(), misfits));
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  if (command.json) {
    Print(json);
    return kGood;
  }
  std::string text = LoadText(model) + HistoryTable(misfits) + EngineText(answer->by);
  for (const std::string& remark : remarks) text += remark + '\n';
  Print(text);
  return kGood;
}

}  // namespace

std::string LoadText(const FittedRun& model) { return model.load ? AddedLoadText(*model.load) + '\n' : ""; }

int Run(const PredictCommand& command) {
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.run / "vehicle.urdf", command.recording}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kPrediction);
    OutputFolder{command.output};
  }
  FittedRun model = LoadModel(command.run);
  model.has_seen = WasFitted(command.run / "result.json", command.recording);
  if (model.has_seen)
    std::fprintf(stderr, "%s: the fit has seen this recording: what follows is fitted, not foretold\n",
                 command.recording.c_str());
  if (model.study.bench)
    Refuse(command.run,
           "is a fit of a damper on its bench, which `predict` does not run: list " +
               command.recording.filename().string() +
               " under `bench: validation` of the study and fit again with the same seed; the fit is the same, and the "
               "recording's nmse_percent is in its table and under `validation` of result.json");
  if (!command.add_mass.empty()) model.load = AddLoad(command.add_mass, command.at, model.vehicle);
  switch (KindOf(command.recording, model.study)) {
    case RecordingKind::kTime:
      if (!command.mode.empty())
        std::fprintf(stderr, "--mode: warning: %s tells itself how its posts moved; the option is left out\n",
                     command.recording.filename().c_str());
      return PredictHistory(command, model);
    case RecordingKind::kFrequency: break;
  }
  RequireUnused("--kalman", command.kalman, command.recording,
                "is a frequency response: this is for recordings over time");
  if (model.study.recordings.empty())
    Refuse(command.recording,
           "is a frequency response, but the model was fitted to none: nothing tells which channels are its sensors");
  return PredictResponses(command, model);
}

}  // namespace fourpost
