#include "vehicles/engine/steady_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <new>
#include <stdexcept>
#include <utility>

#include "analysis/signals/decibel.h"
#include "analysis/text/found.h"
#include "vehicles/engine/findings.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/march.h"
#include "vehicles/response/hysteresis.h"
#include "vehicles/response/reduced_march.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double LargestGain(const ChannelResponse& channel) {
  double largest = 0;
  for (const std::complex<double>& value : channel.response)
    if (std::isfinite(std::abs(value))) largest = std::max(largest, std::abs(value));
  return largest;
}

void Take(double value, double frequency_Hz, const std::string& channel, LargestDifference& largest) {
  if (value > largest.value) largest = {.value = value, .frequency_Hz = frequency_Hz, .channel = channel};
}

/// Puts frequency `from` of `source` in the place of frequency `to`.
void CopyFrequency(const FrequencyResponse& source, std::size_t from, std::size_t to, FrequencyResponse& target) {
  for (std::size_t c = 0; c < target.channels.size(); ++c) {
    target.channels[c].response[to] = source.channels[c].response[from];
    target.channels[c].mean[to] = source.channels[c].mean[from];
    target.channels[c].second_harmonic[to] = source.channels[c].second_harmonic[from];
  }
}

void BlankFrequency(std::size_t index, FrequencyResponse& response) {
  for (ChannelResponse& channel : response.channels) {
    channel.response[index] = {kNone, kNone};
    channel.mean[index] = channel.second_harmonic[index] = kNone;
  }
}

std::vector<bool> Converged(const Excitation& excitation, const std::vector<double>& unconverged_Hz) {
  std::vector<bool> converged;
  for (const double frequency : excitation.frequency_Hz)
    converged.push_back(std::find(unconverged_Hz.begin(), unconverged_Hz.end(), frequency) == unconverged_Hz.end());
  return converged;
}

/// The work was not to go on.
struct Ended {};

}  // namespace

KinematicsError CompareKinematics(const FrequencyResponse& linearised, const FrequencyResponse& full) {
  constexpr double kNode = 0.03;
  constexpr double kSilent = 0.01;
  std::map<std::string, double> loudest;
  for (const ChannelResponse& channel : full.channels)
    loudest[channel.unit] = std::max({1.0, loudest[channel.unit], LargestGain(channel)});
  KinematicsError error;
  for (std::size_t c = 0; c < full.channels.size(); ++c) {
    const ChannelResponse& channel = full.channels[c];
    const double largest = LargestGain(channel);
    if (!(largest > kSilent * loudest[channel.unit])) continue;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const std::complex<double> ratio = linearised.channels[c].response[i] / channel.response[i];
      if (!std::isfinite(std::abs(ratio)) || std::abs(channel.response[i]) < kNode * largest) continue;
      Take(std::abs(DecibelFromGain(std::abs(ratio))), full.frequency_Hz[i], channel.name, error.gain_dB);
      Take(std::abs(DegreesFromRadians(std::arg(ratio))), full.frequency_Hz[i], channel.name, error.phase_deg);
    }
  }
  return error;
}

KinematicsError SteadySolver::Compare(Answer linearised, const Answer& full) {
  for (std::size_t i = 0; i < full.converged.size(); ++i)
    if (!full.converged[i] || !linearised.converged[i]) BlankFrequency(i, linearised.response);
  return CompareKinematics(linearised.response, full.response);
}

SteadySolver::SteadySolver(const Vehicle& vehicle) : vehicle_(vehicle) {
  const CondensedVehicle condensed(vehicle);
  model_ = condensed.At(vehicle.ParameterValues());
}

Multibody& SteadySolver::FullSystem() {
  if (!multibody_) {
    multibody_.emplace(vehicle_);
    multibody_->SetParameters(vehicle_.ParameterValues(), model_.preloads);
  }
  return *multibody_;
}

SteadySolver::Answer SteadySolver::Linearised(const Excitation& excitation, const HarmonicBalanceOptions& options) {
  PeriodicResponse found = SolveHarmonicBalance(model_, vehicle_.sensors, excitation, options);
  return {std::move(found.response), Converged(excitation, found.unconverged_Hz)};
}

SteadySolver::Answer SteadySolver::Full(const Excitation& excitation, const Progress& progress) {
  const auto watch = [&](std::size_t done) {
    if (progress && !progress({"full balance", done, excitation.frequency_Hz.size()})) throw Ended();
  };
  PeriodicResponse found = SolveFullBalance(FullSystem(), model_, excitation, {}, watch);
  return {std::move(found.response), Converged(excitation, found.unconverged_Hz)};
}

/// One balance; what it leaves open is marked for time integration.
SteadyResponse SteadySolver::Chosen(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options,
                                    const Progress& progress) {
  Answer answer = engine == Engine::kFull ? Full(excitation, progress) : Linearised(excitation, options);
  SteadyResponse out{.response = std::move(answer.response), .engine = engine};
  for (const bool converged : answer.converged) out.engine_at.push_back(converged ? engine : Engine::kTimeIntegration);
  return out;
}

SteadyResponse SteadySolver::Check(const Excitation& excitation, const HarmonicBalanceOptions& options,
                                   const Progress& progress) {
  Answer linearised = Linearised(excitation, options);
  const Answer full = Full(excitation, progress);
  SteadyResponse out{.engine = Engine::kReduced};
  bool any = false;
  for (std::size_t i = 0; i < full.converged.size(); ++i) any = any || (full.converged[i] && linearised.converged[i]);
  if (any) out.kinematics_error = Compare(linearised, full);
  else out.not_estimated = Found{&kNothingToCompare}.Text();
  if (any && out.kinematics_error->IsVisible()) out.engine = Engine::kFull;
  const bool is_full = out.engine == Engine::kFull;
  out.response = is_full ? full.response : linearised.response;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    // Where the full balance fails and kinematics matter, the linearised one is no answer.
    const bool converged = is_full ? full.converged[i] : linearised.converged[i];
    const bool rescued = !converged && full.converged[i];
    if (rescued) CopyFrequency(full.response, i, i, out.response);
    out.engine_at.push_back(converged ? out.engine : rescued ? Engine::kFull : Engine::kTimeIntegration);
  }
  if (is_full) {
    for (std::size_t i = 0; i < linearised.converged.size(); ++i)
      if (!linearised.converged[i]) BlankFrequency(i, linearised.response);
    out.linearised = std::move(linearised.response);
  }
  return out;
}

void SteadySolver::FindOtherMotions(const Excitation& excitation, const HarmonicBalanceOptions& options,
                                    const Progress& progress, SteadyResponse& out) {
  const std::vector<bool> several = MayHaveSeveralMotions(model_, excitation, options);
  if (std::find(several.begin(), several.end(), true) == several.end()) return;
  const auto watch = [&](std::size_t done) {
    if (progress && !progress({"from rest", done, excitation.frequency_Hz.size()})) throw Ended();
  };
  FrequencyResponse found = out.linearised.value_or(out.response);
  for (std::size_t i = 0; i < out.engine_at.size(); ++i)
    if (out.engine_at[i] == Engine::kTimeIntegration) BlankFrequency(i, found);
  try {
    out.other_motions = OtherMotionsFromRest(model_, vehicle_, excitation, several, found, watch);
  } catch (const Ended&) {
    // The answers are there; time integration asks once more whether to go on.
  }
}

/// One frequency at a time: where one fails, the others have answers.
void SteadySolver::MarchMissing(const Excitation& excitation, const Progress& progress, SteadyResponse& out) {
  const auto total =
      static_cast<std::size_t>(std::count(out.engine_at.begin(), out.engine_at.end(), Engine::kTimeIntegration));
  std::size_t done = 0;
  bool goes_on = true;
  for (std::size_t i = 0; i < out.engine_at.size(); ++i) {
    if (out.engine_at[i] != Engine::kTimeIntegration) continue;
    goes_on = goes_on && (!progress || progress({"time integration", done, total}));
    ++done;
    const auto stop = [&, stage = Stage{"time integration", done - 1, total}] {
      goes_on = !progress || progress(stage);
      return !goes_on;
    };
    const std::string fault = goes_on ? MarchOne(excitation, i, stop, out) : Found{&kInterrupted}.Text();
    if (fault.empty()) continue;
    BlankFrequency(i, out.response);
    out.unanswered.push_back({excitation.frequency_Hz[i], fault});
  }
}

/// Why there is no answer, if there is none.
std::string SteadySolver::MarchOne(const Excitation& excitation, std::size_t index, const std::function<bool()>& stop,
                                   SteadyResponse& out) {
  const Excitation one{.frequency_Hz = {excitation.frequency_Hz[index]},
                       .amplitude_m = {excitation.amplitude_m[index]},
                       .shape = excitation.shape};
  try {
    const MarchedResponse marched = out.engine == Engine::kReduced ? MarchReduced(model_, RigViewOf(vehicle_), one,
                                                                                  {.tolerance = 1e-4, .stop = stop})
                                                                   : March(FullSystem(), one, {.stop = stop});
    CopyFrequency(marched.response, 0, index, out.response);
    return marched.unsteady.empty() ? "" : UnsteadyMessage(vehicle_, one, marched.unsteady[0]);
  } catch (const MarchStopped&) {
    return Found{&kInterrupted}.Text();
  } catch (const std::logic_error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return failure.what();  // Simbody's own are no runtime_error.
  }
}

SteadyResponse SteadySolver::Balanced(const Excitation& excitation, Engine engine,
                                      const HarmonicBalanceOptions& options, const Progress& progress) {
  const bool is_checked = engine == Engine::kAuto;
  SteadyResponse out =
      is_checked ? Check(excitation, options, progress) : Chosen(excitation, engine, options, progress);
  out.is_hysteretic = out.engine == Engine::kReduced && HasHysteresis(model_);
  if (out.is_hysteretic) out.engine_at.assign(out.engine_at.size(), Engine::kTimeIntegration);
  return out;
}

SteadyResponse SteadySolver::Solve(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options,
                                   const Progress& progress) {
  SteadyResponse out{.response = ResponseRecorder(vehicle_.sensors, excitation).Take(), .engine = engine};
  out.engine_at.assign(excitation.frequency_Hz.size(), engine);
  try {
    if (engine != Engine::kTimeIntegration) out = Balanced(excitation, engine, options, progress);
    if (engine == Engine::kAuto || engine == Engine::kReduced) FindOtherMotions(excitation, options, progress, out);
  } catch (const Ended&) {
    for (std::size_t i = 0; i < out.engine_at.size(); ++i) {
      BlankFrequency(i, out.response);
      out.unanswered.push_back({excitation.frequency_Hz[i], Found{&kInterrupted}.Text()});
    }
    return out;
  }
  MarchMissing(excitation, progress, out);
  return out;
}

}  // namespace fourpost
