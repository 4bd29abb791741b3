#include "identify/command_line/solve_sweep.h"

#include <cstdio>
#include <stdexcept>

#include "analysis/diagnostics.h"
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

void TellMarched(const std::string& name, const Excitation& excitation, Engine engine, const SteadyResponse& answer) {
  std::vector<double> marched;
  for (std::size_t i = 0; i < answer.engine_at.size(); ++i)
    if (answer.engine_at[i] == Engine::kMarch) marched.push_back(excitation.frequency_Hz[i]);
  if (engine == Engine::kMarch || marched.empty()) return;
  std::fprintf(stderr,
               "%s: harmonic balance found no periodic motion at %zu of %zu frequencies, %s: these were marched from "
               "rest\n",
               name.c_str(), marched.size(), answer.engine_at.size(), List(marched).c_str());
}

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

SteadyResponse SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation, Engine engine,
                          const HarmonicBalanceOptions& options, ProgressLine& progress) {
  const auto show = [&](const std::string& text) { progress.Show(name + ": " + text); };
  try {
    SteadyResponse answer = solver.Solve(excitation, engine, options, show);
    TellMarched(name, excitation, engine, answer);
    return answer;
  } catch (const std::invalid_argument& refusal) {
    Diagnostics faults;
    faults.Error("--engine", 0, refusal.what());
    throw FaultyInput(faults);
  }
}

}  // namespace fourpost
