#include <cstdio>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/output_folder.h"
#include "identify/channel_json.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/inputs_elsewhere.h"
#include "identify/command_line/misfit_table.h"
#include "identify/command_line/print.h"
#include "identify/command_line/progress_line.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/solve_sweep.h"
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

/// A misfit needs an answer at every frequency.
FrequencyResponse WholeAnswer(const MeasuredRun& run, SteadySolver& solver, Engine engine, ProgressLine& progress) {
  SteadyResponse answer = SolveSweep(solver, run.name, run.excitation, engine, kFitBalance, progress);
  if (!answer.unanswered.empty()) throw std::runtime_error("'" + run.name + "': " + answer.unanswered.front().why);
  return std::move(answer.response);
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
  Tell(diagnostics);
  if (!command.output.empty()) {
    RequireInputsElsewhere(InputsOf(*loaded), command.output);
    OutputFolder{command.output};
  }
  const Engine engine = command.engine.value_or(Engine::kLinearised);
  const std::vector<MeasuredRun> runs =
      InBand(loaded->data.runs, loaded->study.band_lower_Hz, loaded->study.band_upper_Hz);
  SteadySolver solver(loaded->vehicle);
  RequireStable(loaded->vehicle, solver);
  std::vector<FrequencyResponse> modelled;
  {
    ProgressLine progress;
    for (const MeasuredRun& run : runs) modelled.push_back(WholeAnswer(run, solver, engine, progress));
  }
  const std::vector<ChannelMisfit> misfits = Misfits(runs, modelled);
  if (!command.output.empty()) Write(command, *loaded, runs, modelled, misfits);
  Print(command.json ? AsJson(runs, modelled, misfits) : MisfitTable(misfits));
  return kGood;
}

}  // namespace fourpost
