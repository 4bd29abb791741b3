#include "identify/loaded_study.h"

#include <algorithm>
#include <memory>

#include "analysis/frequency_response_file.h"
#include "analysis/near_file.h"
#include "analysis/nearest.h"
#include "analysis/number.h"
#include "identify/bench_residuals.h"
#include "identify/four_post_residuals.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

bool HasRange(const Parameter& parameter) { return parameter.upper > parameter.lower; }

std::vector<std::size_t> FreeParameters(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics) {
  std::vector<std::size_t> free;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    names.push_back(vehicle.parameters[i].name);
    if (study.free.empty() && HasRange(vehicle.parameters[i])) free.push_back(i);
  }
  for (const std::string& name : study.free) {
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (found == names.end())
      diagnostics.Error(study.file.string(), study.free_line,
                        "the vehicle has no parameter '" + name + "'" + DidYouMean(name, names));
    else if (!HasRange(vehicle.parameters[index]))
      diagnostics.Error(vehicle.file, vehicle.parameters[index].line,
                        "parameter '" + name + "' is to be fitted: give it lower, upper and precision");
    else if (std::find(free.begin(), free.end(), index) != free.end())
      diagnostics.Error(study.file.string(), study.free_line, "parameter '" + name + "' is freed twice");
    else free.push_back(index);
  }
  if (free.empty() && study.free.empty())
    diagnostics.Error(vehicle.file, 0,
                      "no parameter has a range, so there is nothing to fit: give at least one "
                      "fp:parameter lower, upper and precision");
  return free;
}

void CheckBand(const Study& study, const FourPostData& data, Diagnostics& diagnostics) {
  const std::vector<MeasuredRun> runs = InBand(data.runs, study.band_lower_Hz, study.band_upper_Hz);
  for (const MeasuredRun& run : runs)
    if (run.excitation.frequency_Hz.empty())
      diagnostics.Error(study.file.string(), study.band_line,
                        "the band holds no frequency of recording '" + run.name + "'");
}

/// What a Kalman filter cannot serve.
void CheckPrediction(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics) {
  if (study.history_cost != HistoryCost::kPrediction) return;
  for (const StudyHistory& history : study.histories)
    if (history.filter && !history.is_validation)
      diagnostics.Error(
          study.file.string(), history.line,
          "the cost 'prediction' takes recordings as they are: leave 'filter' of history '" + history.name + "' out");
  for (const Damper& damper : vehicle.dampers)
    if (damper.hydraulic)
      diagnostics.Error(vehicle.file, damper.source_line,
                        "the cost 'prediction' corrects positions and velocities, and knows nothing of the oil in the "
                        "hydraulic damper '" +
                            damper.name + "': fit by the cost 'whitened', or give the damper a law without memory");
}

/// Whitened residuals are over a deviation.
void CheckDeviations(const Study& study, const std::vector<MeasuredHistory>& histories, Diagnostics& diagnostics) {
  if (study.history_cost != HistoryCost::kWhitened || study.model_error.history > 0) return;
  for (const MeasuredHistory& history : histories)
    for (const MeasuredSignal& signal : history.signals) {
      if (signal.noise_sd > 0) continue;
      const auto told = std::find_if(study.histories.begin(), study.histories.end(),
                                     [&](const StudyHistory& other) { return other.name == history.name; });
      diagnostics.Error(study.file.string(), told->line,
                        "'" + signal.name + "' of history '" + history.name +
                            "' has neither noise nor a model error, so nothing tells how much its errors count: state "
                            "its 'noise', or 'history' of 'model_error' above zero");
    }
}

/// Whether all files are there that are to be fitted; names the study's own line for one that is not.
bool HasFiles(const Study& study, Diagnostics& diagnostics) {
  bool all = true;
  const auto check = [&](const std::filesystem::path& path, int line) {
    all = RequireFile(path, study.file.string(), line, diagnostics) && all;
  };
  check(study.vehicle, study.vehicle_line);
  for (const StudyRecording& recording : study.recordings) check(recording.file, recording.line);
  for (const StudyHistory& history : study.histories)
    if (!history.is_validation) check(history.file, history.line);
  if (study.bench)
    for (const BenchStudy::Recording& recording : study.bench->recordings) check(recording.file, recording.line);
  return all;
}

}  // namespace

HistoryResiduals::Options LoadedStudy::HistoryOptions() const {
  return {.cost = study.history_cost,
          .model_error = study.model_error.history,
          .noise = kalman_noise,
          .noise_search = {.deadline_s = study.search.deadline_s}};
}

bool LoadedStudy::TellsDeviations() const {
  return histories.empty() || study.history_cost != HistoryCost::kCompromise;
}

void LoadedStudy::EstimateNoise(const std::function<void(int runs)>& progress) {
  if (study.history_cost != HistoryCost::kPrediction) return;
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  kalman_noise.clear();
  try {
    for (const MeasuredHistory& history : histories)
      kalman_noise.push_back(
          KalmanPredictor(history).Estimate(model, {.deadline_s = study.search.deadline_s, .progress = progress}));
  } catch (const TimedOut&) {
    Diagnostics diagnostics;
    diagnostics.Error(study.file.string(), 0,
                      "one run of the Kalman filter takes longer than the deadline of " +
                          FormatNumber(study.search.deadline_s) +
                          " s: raise 'deadline' of 'search', or cut the recording by 'start' and 'end'");
    throw FaultyInput(diagnostics);
  }
}

VehicleObjective LoadedStudy::MakeObjective() const {
  if (bench) return {vehicle, free, {BenchResiduals(vehicle, *bench, study.bench->model_error)}};
  const auto condensed = std::make_shared<const CondensedVehicle>(vehicle);
  std::vector<ResidualBlock> blocks;
  if (!data.runs.empty())
    blocks.push_back(
        FourPostResiduals(condensed, InBand(data.runs, study.band_lower_Hz, study.band_upper_Hz), study.model_error));
  if (!histories.empty()) blocks.push_back(HistoryBlock(condensed, histories, HistoryOptions()));
  if (!data.static_loads.empty()) blocks.push_back(StaticLoadResiduals(condensed, data.static_loads));
  return {vehicle, free, std::move(blocks)};
}

std::optional<LoadedStudy> LoadStudy(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::optional<Study> study = ReadStudy(file, diagnostics);
  if (!study) return std::nullopt;
  if (study->problem) {
    diagnostics.Error(study->file.string(), study->problem_line,
                      "this is a test problem for `fourpost compare`; here a study needs a vehicle and recordings");
    return std::nullopt;
  }
  if (!HasFiles(*study, diagnostics)) return std::nullopt;
  const std::optional<Vehicle> vehicle = ReadVehicle(study->vehicle, diagnostics);
  if (!vehicle) {
    // The recordings' own faults are told as well.
    for (const StudyRecording& recording : study->recordings) ReadFrequencyResponse(recording.file, diagnostics);
    return std::nullopt;
  }
  std::vector<std::size_t> free = FreeParameters(*study, *vehicle, diagnostics);
  std::optional<BenchData> bench;
  if (study->bench) bench = LoadBenchData(*study->bench, study->file.string(), *vehicle, diagnostics);
  std::optional<FourPostData> data = LoadFourPostData(*study, *vehicle, diagnostics);
  if (data) CheckBand(*study, *data, diagnostics);
  std::optional<std::vector<MeasuredHistory>> histories =
      LoadHistories(HistoriesOf(study->histories, false), study->file.string(), *vehicle, diagnostics);
  std::vector<LeftOutRecording> left_out;
  std::vector<MeasuredHistory> validation =
      LoadValidation(HistoriesOf(study->histories, true), study->file.string(), *vehicle, diagnostics, left_out);
  CheckPrediction(*study, *vehicle, diagnostics);
  if (histories) CheckDeviations(*study, *histories, diagnostics);
  if (diagnostics.HasErrors()) return std::nullopt;
  LoadedStudy loaded{*study, *vehicle, std::move(*data), std::move(free)};
  loaded.histories = std::move(*histories);
  loaded.validation = std::move(validation);
  loaded.bench = std::move(bench);
  if (loaded.bench) left_out.insert(left_out.end(), loaded.bench->left_out.begin(), loaded.bench->left_out.end());
  loaded.fitted_files = FittedFiles(*study);
  loaded.validation_files = ValidationFiles(*study, left_out);
  loaded.left_out = std::move(left_out);
  return loaded;
}

}  // namespace fourpost
