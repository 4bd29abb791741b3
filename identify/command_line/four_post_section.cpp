#include <string>
#include <vector>

#include "analysis/decibel.h"
#include "analysis/number.h"
#include "identify/command_line/engine_text.h"
#include "identify/command_line/fit_section.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/text_table.h"
#include "identify/kinematics_check.h"
#include "identify/lint/tyre_pull_lint.h"
#include "identify/modelled_response.h"
#include "identify/response_chart.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

std::string LoadTable(const LoadedStudy& loaded, const std::vector<double>& modelled) {
  if (loaded.data.static_loads.empty()) return "";
  TextTable table({"static load", "measured, N", "sd", "modelled, N"});
  for (const MeasuredLoad& load : loaded.data.static_loads)
    table.Add({loaded.vehicle.tyres[load.tyre].name, Rounded(load.load_N, 5), Rounded(load.sd_N, 3),
               Rounded(modelled[load.tyre], 5)});
  return table.Format() + '\n';
}

/// What the fit's linear kinematics leave out; a warning where that is no longer small beside the stated model error.
void AddKinematics(const LoadedStudy& loaded, const std::vector<MeasuredRun>& runs, const std::vector<double>& values,
                   FitSection& section) {
  constexpr double kMuch = 0.5;
  const ModelError& allowed = loaded.study.model_error;
  section.misfits.kinematics = CheckKinematics(runs, loaded.vehicle, values);
  for (const RunKinematics& run : section.misfits.kinematics) {
    if (!run.error) {
      section.text +=
          run.recording + ": what linear kinematics leave out could not be estimated: " + run.not_estimated + '\n';
      continue;
    }
    section.text += run.recording + ": " + KinematicsText(*run.error) + '\n';
    if (run.error->IsVisible() && (run.error->gain_dB.value > kMuch * allowed.gain_dB ||
                                   run.error->phase_deg.value > kMuch * DegreesFromRadians(allowed.phase_rad)))
      section.findings.Warning(loaded.study.file.string(), 0,
                               "recording '" + run.recording + "': " + KinematicsText(*run.error) +
                                   ", which is not small beside the model error of " + Rounded(allowed.gain_dB, 2) +
                                   " dB and " + Rounded(DegreesFromRadians(allowed.phase_rad), 2) +
                                   " degrees that the study states; the fit makes up for it by its parameters");
  }
  section.text += '\n';
}

void AddResponses(const LoadedStudy& loaded, const FitResult& fit, const CondensedVehicle& vehicle,
                  const CondensedModel& model, FitSection& section) {
  const std::vector<MeasuredRun>& runs = loaded.data.runs;
  const double lower = loaded.study.band_lower_Hz;
  const double upper = loaded.study.band_upper_Hz;
  const std::vector<MeasuredRun> in_band = InBand(runs, lower, upper);
  const std::vector<Sensor>& sensors = loaded.vehicle.sensors;
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, sensors, runs);
  const std::vector<FrequencyResponse> start =
      ModelledResponses(vehicle.At(loaded.vehicle.ParameterValues()), sensors, runs);
  const std::vector<FrequencyResponse> fitted = ModelledResponses(model, sensors, in_band);
  section.misfits.responses = ResponseMisfits(in_band, fitted);
  section.misfits.recordings = RecordingMisfits(in_band, fitted);
  LintTyrePulls(loaded.vehicle, fit.values, in_band, section.findings);
  section.misfits.shares = ErrorShares(in_band, fitted);
  section.text = MisfitTable(section.misfits.responses, section.misfits.recordings) + '\n';
  if (fit.end != FitEnd::kInterrupted) AddKinematics(loaded, in_band, fit.values, section);
  section.files = {{"response.csv", ResponseCsv(runs, modelled, lower, upper, start)},
                   {"response.svg", ResponseSvg(runs, modelled, section.misfits.responses, lower, upper)}};
}

}  // namespace

FitSection FourPostSection(const LoadedStudy& loaded, const FitResult& fit) {
  const std::vector<MeasuredRun>& runs = loaded.data.runs;
  if (runs.empty() && loaded.data.static_loads.empty()) return {};
  const CondensedVehicle vehicle(loaded.vehicle);
  const CondensedModel model = vehicle.At(fit.values);
  FitSection section;
  section.misfits.tyre_loads = model.preloads.tyre;
  if (!runs.empty()) AddResponses(loaded, fit, vehicle, model, section);
  section.text += LoadTable(loaded, model.preloads.tyre);
  return section;
}

}  // namespace fourpost
