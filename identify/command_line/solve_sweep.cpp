#include "identify/command_line/solve_sweep.h"

#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/text_table.h"
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

void TellMarched(const std::string& name, const Excitation& excitation, const SteadyResponse& answer) {
  std::vector<double> marched;
  for (std::size_t i = 0; i < answer.engine_at.size(); ++i)
    if (answer.engine_at[i] == Engine::kMarch) marched.push_back(excitation.frequency_Hz[i]);
  if (marched.empty()) return;
  if (answer.is_hysteretic) {
    std::fprintf(stderr, "%s: friction in line with a spring sticks and slides within a cycle: integrated in time%s\n",
                 name.c_str(), Interrupted() ? " until the interruption" : "");
    return;
  }
  std::fprintf(stderr, "%s: the %s balance converged to no periodic motion at %zu of %zu frequencies, %s: %s\n",
               name.c_str(), EngineName(answer.engine), marched.size(), answer.engine_at.size(), List(marched).c_str(),
               Interrupted() ? "left to the march, which was interrupted" : "these were marched from rest");
}

void TellOtherMotions(const std::string& name, const SteadyResponse& answer) {
  if (answer.other_motions.empty()) return;
  std::vector<double> frequencies;
  OtherMotion most;
  for (const OtherMotion& other : answer.other_motions) {
    frequencies.push_back(other.frequency_Hz);
    if (other.difference > most.difference) most = other;
  }
  std::fprintf(stderr,
               "%s: warning: set in motion from rest, the vehicle takes another motion at %s ('%s' at %s Hz differs by "
               "%s %%): the periodic one told is unstable, or one of several; compare --engine march or `fourpost "
               "simulate`\n",
               name.c_str(), List(frequencies).c_str(), most.channel.c_str(), Rounded(most.frequency_Hz, 3).c_str(),
               Rounded(100 * most.difference, 2).c_str());
}

/// One line for what takes long, with the time left, until the user asks to stop.
class SweepProgress {
 public:
  SweepProgress(ProgressLine& line, const std::string& name) : line_(line), name_(name) {}

  bool operator()(const SteadySolver::Stage& stage) {
    if (stage.work == work_ && stage.done == done_) return !Interrupted();
    if (stage.work != work_) began_ = line_.seconds();
    work_ = stage.work;
    done_ = stage.done;
    const auto done = static_cast<double>(stage.done);
    const double seconds = line_.seconds() - began_;
    line_.Show(work_ + ": " + std::to_string(stage.done) + " of " + std::to_string(stage.total) + " frequencies" +
               TimeLeft(done / static_cast<double>(stage.total), seconds) + Rate(done, seconds, "frequencies") + "; " +
               name_);
    return !Interrupted();
  }

 private:
  ProgressLine& line_;
  std::string name_;
  std::string work_;
  std::size_t done_ = 0;
  double began_ = 0;
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
                                         Engine engine, const HarmonicBalanceOptions& options, ProgressLine& progress) {
  try {
    SteadyResponse answer = solver.Solve(excitation, engine, options, SweepProgress(progress, name));
    if (answer.unanswered.size() == excitation.frequency_Hz.size() && Interrupted()) return std::nullopt;
    if (engine != Engine::kMarch) TellMarched(name, excitation, answer);
    TellOtherMotions(name, answer);
    return answer;
  } catch (const std::invalid_argument& refusal) {
    Diagnostics faults;
    faults.Error("--engine", 0, refusal.what());
    throw FaultyInput(faults);
  }
}

}  // namespace fourpost
