// What a vehicle, as its file has it, makes of stepped sines.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/text_table.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/four_post/misfit_table.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/response_chart.h"
#include "identify/experiments/four_post/response_misfit.h"
#include "identify/experiments/four_post/response_misfit_json.h"
#include "identify/experiments/four_post/tyre_pull_lint.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/requests/channel_json.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep_files.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// A misfit needs an answer at every frequency; nothing when interrupted before.
std::optional<SteadyResponse> WholeAnswer(const MeasuredRun& run, SteadySolver& solver, Engine engine,
                                          const WorkHooks& hooks) {
  std::optional<SteadyResponse> answer = SolveSweep(solver, run.name, run.excitation, engine, kFitBalance, hooks);
  if (!answer) return std::nullopt;
  if (answer->unanswered.empty()) return answer;
  if (hooks.IsStopped()) return std::nullopt;
  const Unanswered& first = answer->unanswered.front();
  throw SimulationError(kResponseUnanswered, {run.name, Rounded(first.frequency_Hz, 3), WithoutId(first.why)});
}

Json AnswerJson(const MeasuredRun& run, const SteadyResponse& answer) {
  Json channels = Json::array();
  for (const ChannelResponse& channel : answer.response.channels) channels.push_back(ChannelJson(channel));
  Json engines = Json::array();
  for (const Engine engine : answer.engine_at) engines.push_back(EngineName(engine));
  return {{"name", run.name},
          {"engine", EngineName(answer.engine)},
          {"linear_kinematics_error", KinematicsJson(answer.kinematics_error, answer.not_estimated)},
          {"frequency_Hz", answer.response.frequency_Hz},
          {"post_amplitude_m", answer.response.amplitude_m},
          {"engine_at", engines},
          {"channels", channels}};
}

/// Runs and what the vehicle answers, one for each.
struct AnsweredRuns {
  std::vector<MeasuredRun> runs;
  std::vector<FrequencyResponse> modelled;

  bool empty() const { return runs.empty(); }
  AnsweredRuns Those(bool is_validation) const {
    AnsweredRuns those;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (runs[r].is_validation != is_validation) continue;
      those.runs.push_back(runs[r]);
      those.modelled.push_back(modelled[r]);
    }
    return those;
  }
  std::string Table(const std::string& above) const {
    return MisfitTable(ResponseMisfits(runs, modelled), RecordingMisfits(runs, modelled), above);
  }
};

/// Those before an interruption.
AnsweredRuns Answered(const std::vector<MeasuredRun>& runs, const Subject& subject, Engine engine,
                      const WorkHooks& hooks, ExperimentResults& results, std::string& engines) {
  SteadySolver solver(subject.vehicle());
  RequireStable(subject.vehicle(), solver);
  AnsweredRuns answered;
  for (const MeasuredRun& run : runs) {
    const std::optional<SteadyResponse> answer = WholeAnswer(run, solver, engine, hooks);
    if (!answer) break;
    results.json["recordings"].push_back(AnswerJson(run, *answer));
    engines += EngineText(run.name, *answer);
    answered.runs.push_back(run);
    answered.modelled.push_back(answer->response);
    if (hooks.IsStopped()) break;
  }
  if (answered.runs.size() < runs.size())
    hooks.Note("interrupted: " + std::to_string(answered.runs.size()) + " of " + std::to_string(runs.size()) +
               " recordings are answered");
  return answered;
}

void AddTables(const AnsweredRuns& answered, const ModelError& model_error, ExperimentResults& results) {
  if (const AnsweredRuns fitted = answered.Those(false); !fitted.empty()) {
    for (const ChannelMisfit& misfit : ResponseMisfits(fitted.runs, fitted.modelled))
      results.json["channels"].push_back(
          {{"name", misfit.name}, {"rms_dB", misfit.rms_dB}, {"rms_deg", misfit.rms_deg}});
    results.text += fitted.Table("");
  }
  if (const AnsweredRuns kept = answered.Those(true); !kept.empty()) {
    results.json["validation"] = UnseenMisfitsJson(kept.runs, kept.modelled, model_error);
    results.text +=
        (results.text.empty() ? "" : "\n") + std::string("Kept for validation:\n") + kept.Table(results.text);
  }
}

}  // namespace

std::optional<ExperimentResults> FourPost::Respond(const Subject& subject, std::optional<Engine> engine,
                                                   const WorkHooks& hooks) const {
  std::vector<MeasuredRun> asked = RunsInBand();
  for (MeasuredRun& run : InBand(validation, plan.band_lower_Hz, plan.band_upper_Hz)) asked.push_back(std::move(run));
  ExperimentResults results;
  if (asked.empty()) return results;
  LintTyrePulls(subject.vehicle(), subject.vehicle().ParameterValues(), asked, results.findings);
  hooks.Find(results.findings);
  std::string engines;
  const AnsweredRuns answered = Answered(asked, subject, engine.value_or(Engine::kAuto), hooks, results, engines);
  if (answered.empty()) return std::nullopt;
  results.is_whole = answered.runs.size() == asked.size();
  AddTables(answered, plan.model_error, results);
  results.text += engines;
  const std::vector<ChannelMisfit> misfits = ResponseMisfits(answered.runs, answered.modelled);
  results.files = {
      {"response.csv", ResponseCsv(answered.runs, answered.modelled, plan.band_lower_Hz, plan.band_upper_Hz)},
      {"response.svg", ResponseSvg(answered.runs, answered.modelled, misfits, plan.band_lower_Hz, plan.band_upper_Hz)}};
  return results;
}

}  // namespace fourpost
