#include "vehicles/requests/solve_sweep.h"

#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "vehicles/requests/findings.h"
#include "vehicles/ride/stability.h"

namespace fourpost {
namespace {

/// "1.20, 1.34 Hz"; of many the first ones.
std::string List(const std::vector<double>& frequencies_Hz) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, frequencies_Hz.size()); ++i)
    text += (i == 0 ? "" : ", ") + Rounded(frequencies_Hz[i], 3);
  return text + (frequencies_Hz.size() > kMost ? " ... Hz" : " Hz");
}

/// Shows a finding about the motion `name` at once.
void Remark(const Finding& kind, const std::string& name, const std::vector<std::string>& words,
            const WorkHooks& hooks) {
  Diagnostics found;
  found.Report(kind, {name}, words);
  hooks.Note(found.Format());
}

void NoteIntegrated(const std::string& name, const Excitation& excitation, const SteadyResponse& answer,
                    const WorkHooks& hooks) {
  std::vector<double> integrated;
  for (std::size_t i = 0; i < answer.engine_at.size(); ++i)
    if (answer.engine_at[i] == Engine::kTimeIntegration) integrated.push_back(excitation.frequency_Hz[i]);
  if (integrated.empty()) return;
  if (answer.is_hysteretic)
    return Remark(kIntegratedHysteresis, name, {hooks.IsStopped() ? " until the interruption" : ""}, hooks);
  Remark(hooks.IsStopped() ? kBalanceInterrupted : kBalanceUnconverged, name,
         {EngineName(answer.engine), std::to_string(integrated.size()), std::to_string(answer.engine_at.size()),
          List(integrated)},
         hooks);
}

void NoteOtherMotions(const std::string& name, const SteadyResponse& answer, const WorkHooks& hooks) {
  if (answer.other_motions.empty()) return;
  std::vector<double> frequencies;
  OtherMotion most;
  for (const OtherMotion& other : answer.other_motions) {
    frequencies.push_back(other.frequency_Hz);
    if (other.difference > most.difference) most = other;
  }
  Remark(kOtherMotion, name,
         {List(frequencies), most.channel, Rounded(most.frequency_Hz, 3) + " Hz",
          Rounded(100 * most.difference, 2) + " %"},
         hooks);
}

/// One line for what takes long, with the time left, until the user asks to stop.
class SweepProgress {
 public:
  SweepProgress(const WorkHooks& hooks, std::string name) : hooks_(hooks), name_(std::move(name)) {}

  bool operator()(const SteadySolver::Stage& stage) {
    if (stage.work == work_ && stage.done == done_) return !hooks_.IsStopped();
    if (stage.work != work_) began_ = Clock::now();
    work_ = stage.work;
    done_ = stage.done;
    const auto done = static_cast<double>(stage.done);
    const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    hooks_.Show(work_ + ": " + std::to_string(stage.done) + " of " + std::to_string(stage.total) + " frequencies" +
                TimeLeft(done / static_cast<double>(stage.total), seconds) + Rate(done, seconds, "frequencies") + "; " +
                name_);
    return !hooks_.IsStopped();
  }

 private:
  using Clock = std::chrono::steady_clock;

  const WorkHooks& hooks_;
  std::string name_;
  std::string work_;
  std::size_t done_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

void RequireStable(const Vehicle& vehicle, const SteadySolver& solver) {
  const std::optional<Growth> growth = GrowthOf(vehicle, solver.model());
  if (!growth) return;
  Refuse(kUnstable, {vehicle.file}, {growth->Text()});
}

std::optional<SteadyResponse> SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                                         Engine engine, const HarmonicBalanceOptions& options, const WorkHooks& hooks) {
  try {
    SteadyResponse answer = solver.Solve(excitation, engine, options, SweepProgress(hooks, name));
    if (answer.unanswered.size() == excitation.frequency_Hz.size() && hooks.IsStopped()) return std::nullopt;
    if (engine != Engine::kTimeIntegration) NoteIntegrated(name, excitation, answer, hooks);
    NoteOtherMotions(name, answer, hooks);
    return answer;
  } catch (const std::invalid_argument& refusal) {
    Refuse(kEngineRefused, Place::Option("--engine"), {refusal.what()});
  }
}

}  // namespace fourpost
