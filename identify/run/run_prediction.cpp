#include "identify/run/run_prediction.h"

#include <system_error>
#include <utility>
#include <vector>

#include "analysis/files/json_text.h"
#include "analysis/files/recorded_table.h"
#include "identify/run/findings.h"
#include "identify/run/run_spread.h"
#include "identify/study/fitted_files.h"
#include "identify/study/loaded_study.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

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

}  // namespace

FittedRun LoadFittedRun(const std::filesystem::path& folder) {
  for (const char* name : {"vehicle.urdf", "study.yaml"})
    if (std::error_code failure; !std::filesystem::exists(folder / name, failure))
      Refuse(kRunFileMissing, {folder.string()}, {name});
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicle(folder / "vehicle.urdf", diagnostics);
  std::optional<Study> study = ReadStudy(folder / "study.yaml", diagnostics);
  if (!vehicle || !study) throw FaultyInput(diagnostics);
  return {.folder = folder, .vehicle = std::move(*vehicle), .study = std::move(*study)};
}

std::optional<ExperimentResults> PredictRecording(const FittedRun& run, PredictionRequest request,
                                                  const WorkHooks& hooks) {
  const std::vector<std::size_t> free;
  Subject subject(run.vehicle, free, run.folder / "study.yaml");
  subject.FollowControl(ControlOf(run.study, run.vehicle));
  const Experiment& experiment = ExperimentOf(request.recording, run.study);
  std::optional<RunSpread> spread;
  if (HasRunSpread(run.folder)) spread = ReadRunSpread(run.folder);
  request.run = run.folder;
  request.spread = spread ? &spread->parameters : nullptr;
  std::optional<ExperimentResults> results = experiment.Predict(subject, request, hooks);
  if (results && spread && results->json.contains("band_95") && !spread->Held().empty())
    results->findings.Report(kBandsWithoutParameters, {run.folder.string()}, {spread->HeldText()});
  return results;
}

std::string PredictionJson(const FittedRun& run, const std::filesystem::path& recording,
                           const nlohmann::ordered_json& beside, const ExperimentResults& results) {
  nlohmann::ordered_json versions = nlohmann::ordered_json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  nlohmann::ordered_json json = {{"vehicle", run.vehicle.name},
                                 {"recording", recording.filename().string()},
                                 {"was_fitted", WasFitted(run.folder / "result.json", recording)}};
  json.update(beside);
  json.update(results.json);
  json.update({{"warnings", WarningsJson(results.findings)}, {"versions", versions}});
  return JsonText(json);
}

}  // namespace fourpost
