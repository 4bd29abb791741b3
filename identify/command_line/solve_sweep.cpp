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
  std::fprintf(stderr,
               "%s: harmonic balance found no periodic motion at %zu of %zu frequencies, %s: these were marched from "
               "rest\n",
               name.c_str(), marched.size(), answer.engine_at.size(), List(marched).c_str());
}

/// The user asked to stop.
struct Interruption {};

template <typename Value>
void Append(const std::vector<Value>& values, std::vector<Value>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

void Append(const SteadyResponse& part, SteadyResponse& all) {
  Append(part.response.frequency_Hz, all.response.frequency_Hz);
  Append(part.response.amplitude_m, all.response.amplitude_m);
  for (std::size_t c = 0; c < all.response.channels.size(); ++c) {
    Append(part.response.channels[c].response, all.response.channels[c].response);
    Append(part.response.channels[c].mean, all.response.channels[c].mean);
    Append(part.response.channels[c].second_harmonic, all.response.channels[c].second_harmonic);
  }
  Append(part.engine_at, all.engine_at);
  Append(part.unanswered, all.unanswered);
}

/// A frequency that was not tried; channels as those of `like`.
SteadyResponse NotTried(double frequency_Hz, double amplitude_m, const SteadyResponse& like) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  SteadyResponse none{.response = {.frequency_Hz = {frequency_Hz}, .amplitude_m = {amplitude_m}},
                      .engine_at = {Engine::kMarch},
                      .unanswered = {{frequency_Hz, "interrupted before"}}};
  for (const ChannelResponse& channel : like.response.channels)
    none.response.channels.push_back({.name = channel.name,
                                      .unit = channel.unit,
                                      .response = {{kNone, kNone}},
                                      .mean = {kNone},
                                      .second_harmonic = {kNone}});
  return none;
}

/// A march starts each frequency from rest: one by one they may be ended, and keep what is done.
SteadyResponse MarchEach(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                         ProgressLine& progress) {
  const std::size_t count = excitation.frequency_Hz.size();
  const double began = progress.seconds();
  std::optional<SteadyResponse> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double frequency = excitation.frequency_Hz[i];
    const double amplitude = excitation.amplitude_m[i];
    progress.Show(name + ": march: " + std::to_string(i) + " of " + std::to_string(count) + " frequencies" +
                  TimeLeft(static_cast<double>(i) / static_cast<double>(count), progress.seconds() - began));
    const bool stop = all && Interrupted();
    const SteadyResponse part =
        stop ? NotTried(frequency, amplitude, *all)
             : solver.Solve({.frequency_Hz = {frequency}, .amplitude_m = {amplitude}, .shape = excitation.shape},
                            Engine::kMarch);
    if (all) Append(part, *all);
    else all = part;
  }
  return std::move(all).value();
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

std::optional<SteadyResponse> SolveSweep(SteadySolver& solver, const std::string& name, const Excitation& excitation,
                                         Engine engine, const HarmonicBalanceOptions& options, ProgressLine& progress) {
  const auto show = [&](const std::string& text) {
    progress.Show(name + ": " + text);
    if (Interrupted()) throw Interruption();
  };
  try {
    if (engine == Engine::kMarch) return MarchEach(solver, name, excitation, progress);
    SteadyResponse answer = solver.Solve(excitation, engine, options, show);
    TellMarched(name, excitation, answer);
    return answer;
  } catch (const Interruption&) {
    return std::nullopt;
  } catch (const std::invalid_argument& refusal) {
    Diagnostics faults;
    faults.Error("--engine", 0, refusal.what());
    throw FaultyInput(faults);
  }
}

}  // namespace fourpost
