#include "vehicles/requests/solve_sweep.h"

#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
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

void NoteIntegrated(const std::string& name, const Excitation& excitation, const SteadyResponse& answer,
                    const WorkHooks& hooks) {
  std::vector<double> integrated;
  for (std::size_t i = 0; i < answer.engine_at.size(); ++i)
    if (answer.engine_at[i] == Engine::kMarch) integrated.push_back(excitation.frequency_Hz[i]);
  if (integrated.empty()) return;
  if (answer.is_hysteretic)
    return hooks.Note(name + ": friction in line with a spring sticks and slides within a cycle: integrated in time" +
                      (hooks.IsStopped() ? " until the interruption" : ""));
  hooks.Note(name + ": the " + EngineName(answer.engine) + " balance converged to no periodic motion at " +
             std::to_string(integrated.size()) + " of " + std::to_string(answer.engine_at.size()) + " frequencies, " +
             List(integrated) + ": " +
             (hooks.IsStopped() ? "left to the march, which was interrupted" : "these were marched from rest"));
}

void NoteOtherMotions(const std::string& name, const SteadyResponse& answer, const WorkHooks& hooks) {
  if (answer.other_motions.empty()) return;
  std::vector<double> frequencies;
  OtherMotion most;
  for (const OtherMotion& other : answer.other_motions) {
    frequencies.push_back(other.frequency_Hz);
    if (other.difference > most.difference) most = other;
  }
  hooks.Note(name + ": warning: set in motion from rest, the vehicle takes another motion at " + List(frequencies) +
             " ('" + most.channel + "' at " + Rounded(most.frequency_Hz, 3) + " Hz differs by " +
             Rounded(100 * most.difference, 2) +
             " %): the periodic one told is unstable, or one of several; compare --engine march or `fourpost "
             "simulate`");
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
  Diagnostics faults;
  faults.Error(vehicle.file, 0,
               "the vehicle is unstable in its design pose, so it has no steady response: " + growth->Text() +
                   "; see `fourpost check`");
  throw FaultyInput(faults);
}

std::optional<SteadyResponse> SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                                         Engine engine, const HarmonicBalanceOptions& options, const WorkHooks& hooks) {
  try {
    SteadyResponse answer = solver.Solve(excitation, engine, options, SweepProgress(hooks, name));
    if (answer.unanswered.size() == excitation.frequency_Hz.size() && hooks.IsStopped()) return std::nullopt;
    if (engine != Engine::kMarch) NoteIntegrated(name, excitation, answer, hooks);
    NoteOtherMotions(name, answer, hooks);
    return answer;
  } catch (const std::invalid_argument& refusal) {
    Diagnostics faults;
    faults.Error("--engine", 0, refusal.what());
    throw FaultyInput(faults);
  }
}

}  // namespace fourpost
