#include <optional>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/output_folder.h"
#include "identify/command_line/condensed_at_values.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/locked_friction.h"
#include "identify/command_line/print.h"
#include "identify/command_line/response_text.h"
#include "identify/command_line/responses.h"
#include "identify/command_line/results_line.h"
#include "identify/command_line/work_progress.h"
#include "identify/report/vehicle_page.h"
#include "identify/run/result_kind.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep.h"
#include "vehicles/requests/sweep_files.h"
#include "vehicles/response/friction_lock.h"
#include "vehicles/response/tyre_pull.h"

namespace fourpost {
namespace {

/// What was read, without a fault.
struct ResponseJob {
  Vehicle vehicle;
  SweepRequest request;
  Diagnostics findings;
};

ResponseJob ReadJob(const ResponseCommand& command) {
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(command.input, findings);
  if (!vehicle) throw FaultyInput(findings);
  SetParameters(command.set, *vehicle, findings);
  std::optional<SweepRequest> request = ReadSweep(command.sweep, *vehicle, findings);
  if (findings.HasErrors() || !request) throw FaultyInput(findings);
  return {std::move(*vehicle), std::move(*request), std::move(findings)};
}

void Write(const std::filesystem::path& folder, const std::string& json, const ResponseJob& job,
           const std::vector<SweptResponse>& responses) {
  const Vehicle& vehicle = job.vehicle;
  OutputFolder output(folder);
  output.Add("response.csv", SweepCsv(responses));
  output.Add("response.svg", SweepSvg(vehicle.name, responses));
  output.Add(kPageName, VehiclePage(vehicle, {.facts = {"frequency responses"},
                                              .file = VehicleTextWithValues(vehicle, vehicle.ParameterValues(),
                                                                            std::filesystem::absolute(folder)),
                                              .findings = job.findings,
                                              .responses = responses}));
  output.Add("result.json", json);
  output.Commit();
  PrintResultsLine(folder);
}

/// How many frequencies have an answer, of how many asked for. Reports of each sweep how many have none.
struct Count {
  std::size_t answered = 0;
  std::size_t all = 0;
};

Count CountAnswers(const SweepRequest& request, const std::vector<SweptResponse>& responses) {
  Count count;
  for (const Sweep& sweep : request.sweeps) count.all += sweep.excitation.frequency_Hz.size();
  for (const SweptResponse& swept : responses) {
    const std::size_t all = swept.excitation.frequency_Hz.size();
    const std::size_t none = swept.answer.unanswered.size();
    count.answered += all - none;
    if (none > 0) Tell(kFrequenciesUnanswered, {}, {swept.mode, std::to_string(none), std::to_string(all)});
  }
  return count;
}

/// Sweeps as far as the user lets them be.
std::vector<SweptResponse> SolveAll(SteadySolver& solver, const SweepRequest& request, Engine engine) {
  CatchInterrupts();
  WorkProgress progress;
  std::vector<SweptResponse> responses;
  for (const Sweep& sweep : request.sweeps) {
    std::optional<SteadyResponse> answer =
        SolveSweep(solver, sweep.mode, sweep.excitation, engine, {}, progress.Hooks());
    if (answer) responses.push_back(Sorted(sweep, std::move(*answer), request.channels));
    if (Interrupted()) break;
  }
  return responses;
}

int CodeOf(const Count& count) {
  if (count.answered == count.all) return kGood;
  if (Interrupted()) return kInterrupted;
  return count.answered == 0 ? kAllSimulationsFailed : kNotGood;
}

}  // namespace

int RespondOfVehicle(const ResponseCommand& command) {
  ResponseJob job = ReadJob(command);
  if (!command.output.empty()) {
    RequireInputsElsewhere({command.input}, command.output);
    RequireNoOtherResult(command.output, ResultKind::kResponse);
    OutputFolder{command.output};
  }
  CondensedAtValues(job.vehicle);
  SteadySolver solver(job.vehicle);
  RequireStable(job.vehicle, solver);
  for (const Sweep& sweep : job.request.sweeps) {
    WarnOfLocked(job.vehicle, FindLockedFriction(job.vehicle, sweep.excitation), sweep.mode, job.findings);
    WarnOfPulls(job.vehicle, FindTyrePulls(job.vehicle, job.vehicle.ParameterValues(), sweep.excitation), "frequencies",
                sweep.mode, job.findings);
  }
  Tell(job.findings);
  const std::vector<SweptResponse> responses = SolveAll(solver, job.request, command.engine.value_or(Engine::kAuto));
  const Count count = CountAnswers(job.request, responses);
  if (Interrupted()) Tell(kResponseInterrupted, {}, {std::to_string(count.answered), std::to_string(count.all)});
  if (responses.empty()) return kInterrupted;
  const std::string json = SweepJson(job.vehicle, job.request, responses, job.findings);
  if (!command.output.empty()) Write(command.output, json, job, responses);
  if (command.json) Print(json);
  else PrintText(ResponseText(job.request, responses));
  return CodeOf(count);
}

}  // namespace fourpost
