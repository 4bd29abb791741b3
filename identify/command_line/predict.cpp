#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/number.h"
#include "analysis/output_folder.h"
#include "analysis/recorded_table.h"
#include "analysis/time_recording.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/history_table.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/predictions.h"
#include "identify/command_line/print.h"
#include "identify/history_fit_files.h"
#include "identify/history_residuals.h"
#include "identify/option_quantity.h"
#include "identify/study.h"
#include "identify/versions.h"
#include "vehicles/description/added_mass.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void Refuse(const std::filesystem::path& file, const std::string& message) {
  Diagnostics faults;
  faults.Error(file.string(), 0, message);
  throw FaultyInput(faults);
}

/// Throws FaultyInput.
FittedRun LoadModel(const std::filesystem::path& run) {
  for (const char* name : {"vehicle.urdf", "study.yaml"})
    if (!std::filesystem::exists(run / name))
      Refuse(run, std::string("holds no ") + name + ": the folder that `fourpost fit -o` wrote is wanted");
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicle(run / "vehicle.urdf", diagnostics);
  std::optional<Study> study = ReadStudy(run / "study.yaml", diagnostics);
  if (!vehicle || !study) throw FaultyInput(diagnostics);
  return {std::move(*vehicle), std::move(*study)};
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
StudyHistory Layout(const Study& study, const std::filesystem::path& recording, bool as_recorded) {
  if (study.histories.empty())
    Refuse(recording,
           "is a recording over time, but the model was fitted to none: nothing tells which channels are its "
           "posts and sensors");
  StudyHistory history = study.histories.front();
  history.file = recording;
  history.name = recording.stem().string();
  history.end_s.reset();
  if (as_recorded) history.filter.reset();
  return history;
}

std::string AsJson(const PredictCommand& command, const FittedRun& model, const MeasuredHistory& history,
                   const std::vector<HistoryMisfit>& misfits) {
  Json channels = Json::array();
  for (const HistoryMisfit& misfit : misfits) {
    channels.push_back({{"recording", misfit.recording},
                        {"name", misfit.name},
                        {"nmse_percent", misfit.nmse_percent},
                        {"vaf_percent", misfit.vaf_percent},
                        {"gain", *misfit.gain},
                        {"delay_s", *misfit.delay_s}});
    if (!misfit.one_step_nmse_percent) continue;
    channels.back()["one_step_nmse_percent"] = *misfit.one_step_nmse_percent;
    channels.back()["innovation_correlation"] = *misfit.innovation_correlation;
  }
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;
  return Json{{"vehicle", model.vehicle.name}, {"recording", command.recording.filename().string()},
              {"start_s", history.TimeAt(0)},  {"end_s", history.TimeAt(history.count - 1)},
              {"samples", history.count},      {"channels", channels},
              {"versions", versions}}
             .dump(2) +
         '\n';
}

int PredictHistory(const PredictCommand& command, const FittedRun& model) {
  Diagnostics diagnostics;
  const std::optional<std::vector<MeasuredHistory>> histories =
      LoadHistories({Layout(model.study, command.recording, command.kalman)}, (command.run / "study.yaml").string(),
                    model.vehicle, diagnostics);
  if (!histories) throw FaultyInput(diagnostics);
  Tell(diagnostics);
  const HistoryResiduals residuals(std::make_shared<const CondensedVehicle>(model.vehicle), *histories,
                                   {.cost = command.kalman ? HistoryCost::kPrediction : HistoryCost::kWhitened});
  const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(model.vehicle.ParameterValues());
  std::vector<HistoryMisfit> misfits = HistoryMisfits(*histories, modelled);
  if (command.kalman) AddOneStepErrors(*histories, residuals.Predicted(model.vehicle.ParameterValues()), misfits);
  const MeasuredHistory& history = histories->front();
  const std::string json = AsJson(command, model, history, misfits);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.run / "vehicle.urdf", command.recording}, command.output);
    OutputFolder output(command.output);
    output.Add("history.csv", HistoryFitCsv(*histories, modelled));
    output.Add("history.svg", HistoryFitSvg(history, modelled.front(), misfits));
    output.Add("result.json", json);
    output.Commit();
    std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
  }
  Print(command.json ? json : HistoryTable(misfits) + HistoryRemarks(misfits, 1 / history.rate_Hz));
  return kGood;
}

/// Throws FaultyInput.
void AddLoad(const PredictCommand& command, Vehicle& vehicle) {
  Diagnostics diagnostics;
  const std::optional<double> mass = ReadQuantity(command.add_mass, kMass, "--add-mass", diagnostics);
  Eigen::Vector3d place;
  std::istringstream text(command.at);
  for (int k = 0; k < 3; ++k) {
    std::string number;
    std::getline(text, number, ',');
    const std::optional<double> metres = ParseNumber(number);
    if (!metres) {
      diagnostics.Error("--at", 0, "wants three numbers in metres such as -1.2,0,0.9, got '" + command.at + "'");
      break;
    }
    place[k] = *metres;
  }
  if (!diagnostics.HasErrors() && text.peek() != std::istringstream::traits_type::eof())
    diagnostics.Error("--at", 0, "wants three numbers in metres such as -1.2,0,0.9, got '" + command.at + "'");
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  vehicle = WithMass(vehicle, vehicle.ParameterValues(), *mass, place);
}

}  // namespace

int Run(const PredictCommand& command) {
  FittedRun model = LoadModel(command.run);
  if (model.study.bench)
    Refuse(command.run,
           "is a fit of a damper on its bench: list other recordings under `bench: validation` of its study");
  if (!command.add_mass.empty()) AddLoad(command, model.vehicle);
  switch (KindOf(command.recording, model.study)) {
    case RecordingKind::kTime: return PredictHistory(command, model);
    case RecordingKind::kFrequency: break;
  }
  if (model.study.recordings.empty())
    Refuse(command.recording,
           "is a frequency response, but the model was fitted to none: nothing tells which channels are its sensors");
  return PredictResponses(command, model);
}

}  // namespace fourpost
