#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "identify/bench_result.h"
#include "identify/channel_json.h"
#include "identify/command_line/engine_text.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/history_table.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/result_kind.h"
#include "identify/command_line/solve_sweep.h"
#include "identify/history_misfit_json.h"
#include "identify/history_residuals.h"
#include "identify/json_text.h"
#include "identify/lint/recording_lint.h"
#include "identify/lint/tyre_pull_lint.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"
#include "identify/modelled_response.h"
#include "identify/response_chart.h"
#include "identify/sweep_files.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// Of recordings over time.
struct TimeMisfits {
  std::vector<HistoryMisfit> fitted;
  std::vector<HistoryMisfit> validation;
};

std::string AsJson(const std::vector<MeasuredRun>& runs, const std::vector<SteadyResponse>& answers,
                   const std::vector<ChannelMisfit>& misfits, const TimeMisfits& over_time) {
  Json recordings = Json::array();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Json channels = Json::array();
    const SteadyResponse& answer = answers[r];
    for (const ChannelResponse& channel : answer.response.channels) channels.push_back(ChannelJson(channel));
    Json engines = Json::array();
    for (const Engine engine : answer.engine_at) engines.push_back(EngineName(engine));
    recordings.push_back({{"name", runs[r].name},
                          {"engine", EngineName(answer.engine)},
                          {"linear_kinematics_error", KinematicsJson(answer.kinematics_error, answer.not_estimated)},
                          {"frequency_Hz", answer.response.frequency_Hz},
                          {"post_amplitude_m", answer.response.amplitude_m},
                          {"engine_at", engines},
                          {"channels", channels}});
  }
  Json channels = HistoryMisfitsJson(over_time.fitted);
  for (const ChannelMisfit& misfit : misfits)
    channels.push_back({{"name", misfit.name}, {"rms_dB", misfit.rms_dB}, {"rms_deg", misfit.rms_deg}});
  Json json = {{"recordings", recordings}, {"channels", channels}};
  if (!over_time.validation.empty()) json["validation"] = HistoryMisfitsJson(over_time.validation);
  return JsonText(json);
}

/// A misfit needs an answer at every frequency; nothing when interrupted before.
std::optional<SteadyResponse> WholeAnswer(const MeasuredRun& run, SteadySolver& solver, Engine engine,
                                          ProgressLine& progress) {
  std::optional<SteadyResponse> answer = SolveSweep(solver, run.name, run.excitation, engine, kFitBalance, progress);
  if (!answer) return std::nullopt;
  if (answer->unanswered.empty()) return answer;
  if (Interrupted()) return std::nullopt;
  throw SimulationError("'" + run.name + "': " + answer->unanswered.front().why);
}

/// Those of the recordings that come before an interruption.
std::vector<SteadyResponse> WholeAnswers(const std::vector<MeasuredRun>& runs, SteadySolver& solver, Engine engine) {
  CatchInterrupts();
  ProgressLine progress;
  std::vector<SteadyResponse> answers;
  for (const MeasuredRun& run : runs) {
    std::optional<SteadyResponse> answer = WholeAnswer(run, solver, engine, progress);
    if (answer) answers.push_back(std::move(*answer));
    if (Interrupted()) break;
  }
  return answers;
}

std::string EnginesText(const std::vector<MeasuredRun>& runs, const std::vector<SteadyResponse>& answers) {
  std::string text;
  for (std::size_t r = 0; r < runs.size(); ++r) text += EngineText(runs[r].name, answers[r]);
  return text;
}

void Write(const ResponseCommand& command, const LoadedStudy& loaded, const std::vector<MeasuredRun>& runs,
           const std::vector<FrequencyResponse>& modelled, const std::vector<ChannelMisfit>& misfits,
           const std::string& json) {
  const double lower = loaded.study.band_lower_Hz;
  const double upper = loaded.study.band_upper_Hz;
  OutputFolder output(command.output);
  output.Add("response.csv", ResponseCsv(runs, modelled, lower, upper));
  output.Add("response.svg", ResponseSvg(runs, modelled, misfits, lower, upper));
  output.Add("result.json", json);
  output.Commit();
  std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
}

/// How the vehicle as it stands misses recordings over time.
TimeMisfits OverTime(const LoadedStudy& loaded) {
  const std::vector<double> values = loaded.vehicle.ParameterValues();
  if (loaded.bench) {
    const BenchDamper damper(loaded.vehicle, loaded.bench->damper);
    const auto misfits = [&](const std::vector<BenchRecording>& recordings) {
      return BenchMisfits(ModelledRecordings(damper, recordings, values));
    };
    return {misfits(loaded.bench->fitted), misfits(loaded.bench->validation)};
  }
  if (loaded.histories.empty() && loaded.validation.empty()) return {};
  const auto condensed = std::make_shared<const CondensedVehicle>(loaded.vehicle);
  const auto misfits = [&](const std::vector<MeasuredHistory>& histories) {
    if (histories.empty()) return std::vector<HistoryMisfit>();
    const HistoryResiduals residuals(condensed, histories, {});
    Diagnostics findings;
    LintTyrePulls(loaded.vehicle, values, histories, residuals.Steps(), findings);
    Tell(findings);
    return HistoryMisfits(histories, residuals.Modelled(values));
  };
  return {misfits(loaded.histories), misfits(loaded.validation)};
}

/// Empty without any.
std::string TableOf(const TimeMisfits& misfits) {
  std::vector<HistoryMisfit> all = misfits.fitted;
  all.insert(all.end(), misfits.validation.begin(), misfits.validation.end());
  return all.empty() ? "" : HistoryTable(all);
}

/// Of a study without stepped sines.
int TellOverTime(const ResponseCommand& command, const LoadedStudy& loaded) {
  Diagnostics diagnostics;
  for (const auto& [option, is_used] :
       {std::pair{"--output", !command.output.empty()}, {"--engine", command.engine.has_value()}})
    if (is_used)
      diagnostics.Error(option, 0,
                        "is for stepped sines, which this study does not have; leave it out for the errors "
                        "of its recordings, or `fourpost fit` it");
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  const TimeMisfits misfits = OverTime(loaded);
  Print(command.json ? AsJson({}, {}, {}, misfits) : TableOf(misfits));
  return kGood;
}

}  // namespace

int RespondToStudy(const ResponseCommand& command) {
  Diagnostics diagnostics;
  const std::optional<LoadedStudy> loaded = LoadStudy(command.input, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  LintRecordings(*loaded, diagnostics);
  const std::vector<double> values = loaded->vehicle.ParameterValues();
  if (!loaded->data.runs.empty())
    LintTyrePulls(loaded->vehicle, values,
                  InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz), diagnostics);
  Tell(diagnostics);
  if (loaded->data.runs.empty()) return TellOverTime(command, *loaded);
  if (!command.output.empty()) {
    RequireInputsElsewhere(InputsOf(*loaded), command.output);
    RequireNoOtherResult(command.output, ResultKind::kResponse);
    OutputFolder{command.output};
  }
  const Engine engine = command.engine.value_or(Engine::kAuto);
  std::vector<MeasuredRun> runs = InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  SteadySolver solver(loaded->vehicle);
  RequireStable(loaded->vehicle, solver);
  const std::vector<SteadyResponse> answers = WholeAnswers(runs, solver, engine);
  std::vector<FrequencyResponse> modelled;
  for (const SteadyResponse& answer : answers) modelled.push_back(answer.response);
  const bool is_whole = modelled.size() == runs.size();
  if (!is_whole)
    std::fprintf(stderr, "interrupted: %zu of %zu recordings are answered\n", modelled.size(), runs.size());
  if (modelled.empty()) return kInterrupted;
  runs.resize(modelled.size());
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(runs, modelled);
  const TimeMisfits over_time = is_whole ? OverTime(*loaded) : TimeMisfits();
  const std::string json = AsJson(runs, answers, misfits, over_time);
  if (!command.output.empty()) Write(command, *loaded, runs, modelled, misfits, json);
  Print(command.json
            ? json
            : MisfitTable(misfits, RecordingMisfits(runs, modelled)) + EnginesText(runs, answers) + TableOf(over_time));
  return is_whole ? kGood : kInterrupted;
}

}  // namespace fourpost
