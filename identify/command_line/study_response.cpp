#include <cstdio>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "identify/channel_json.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/solve_sweep.h"
#include "identify/lint/recording_lint.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"
#include "identify/modelled_response.h"
#include "identify/response_chart.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::string AsJson(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled,
                   const std::vector<ChannelMisfit>& misfits) {
  Json recordings = Json::array();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Json channels = Json::array();
    for (const ChannelResponse& channel : modelled[r].channels) channels.push_back(ChannelJson(channel));
    recordings.push_back({{"name", runs[r].name},
                          {"frequency_Hz", modelled[r].frequency_Hz},
                          {"post_amplitude_m", modelled[r].amplitude_m},
                          {"channels", channels}});
  }
  Json channels = Json::array();
  for (const ChannelMisfit& misfit : misfits)
    channels.push_back({{"name", misfit.name}, {"rms_dB", misfit.rms_dB}, {"rms_deg", misfit.rms_deg}});
  return Json{{"recordings", recordings}, {"channels", channels}}.dump(2) + '\n';
}

/// A misfit needs an answer at every frequency; nothing when interrupted before.
std::optional<FrequencyResponse> WholeAnswer(const MeasuredRun& run, SteadySolver& solver, Engine engine,
                                             ProgressLine& progress) {
  std::optional<SteadyResponse> answer = SolveSweep(solver, run.name, run.excitation, engine, kFitBalance, progress);
  if (!answer) return std::nullopt;
  if (answer->unanswered.empty()) return std::move(answer->response);
  if (Interrupted()) return std::nullopt;
  throw std::runtime_error("'" + run.name + "': " + answer->unanswered.front().why);
}

/// Those of the recordings that come before an interruption.
std::vector<FrequencyResponse> WholeAnswers(const std::vector<MeasuredRun>& runs, SteadySolver& solver, Engine engine) {
  CatchInterrupts();
  ProgressLine progress;
  std::vector<FrequencyResponse> modelled;
  for (const MeasuredRun& run : runs) {
    std::optional<FrequencyResponse> answer = WholeAnswer(run, solver, engine, progress);
    if (answer) modelled.push_back(std::move(*answer));
    if (Interrupted()) break;
  }
  return modelled;
}

void Write(const ResponseCommand& command, const LoadedStudy& loaded, const std::vector<MeasuredRun>& runs,
           const std::vector<FrequencyResponse>& modelled, const std::vector<ChannelMisfit>& misfits) {
  const double lower = loaded.study.band_lower_Hz;
  const double upper = loaded.study.band_upper_Hz;
  OutputFolder output(command.output);
  output.Add("response.csv", ResponseCsv(runs, modelled, lower, upper));
  output.Add("response.svg", ResponseSvg(runs, modelled, misfits, lower, upper));
  output.Add("result.json", AsJson(runs, modelled, misfits));
  output.Commit();
  std::fprintf(stderr, "results: %s\n", command.output.string().c_str());
}

}  // namespace

int RespondToStudy(const ResponseCommand& command) {
  Diagnostics diagnostics;
  const std::optional<LoadedStudy> loaded = LoadStudy(command.input, diagnostics);
  if (!loaded) throw FaultyInput(diagnostics);
  LintRecordings(*loaded, diagnostics);
  Tell(diagnostics);
  if (!command.output.empty()) {
    RequireInputsElsewhere(InputsOf(*loaded), command.output);
    OutputFolder{command.output};
  }
  const Engine engine = command.engine.value_or(Engine::kLinearised);
  std::vector<MeasuredRun> runs = InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  SteadySolver solver(loaded->vehicle);
  RequireStable(loaded->vehicle, solver);
  const std::vector<FrequencyResponse> modelled = WholeAnswers(runs, solver, engine);
  const bool is_whole = modelled.size() == runs.size();
  if (!is_whole)
    std::fprintf(stderr, "interrupted: %zu of %zu recordings are answered\n", modelled.size(), runs.size());
  if (modelled.empty()) return kInterrupted;
  runs.resize(modelled.size());
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(runs, modelled);
  if (!command.output.empty()) Write(command, *loaded, runs, modelled, misfits);
  Print(command.json ? AsJson(runs, modelled, misfits) : MisfitTable(misfits, RecordingMisfits(runs, modelled)));
  return is_whole ? kGood : kInterrupted;
}

}  // namespace fourpost
