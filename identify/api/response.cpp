#include <fourpost/response.h>

#include <algorithm>
#include <cmath>

#include "identify/api/engine_names.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/api/inside.h"
#include "identify/api/responses.h"
#include "identify/api/vectors.h"
#include "vehicles/requests/post_shape.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost::api {
namespace {

ChannelResponse ChannelOf(const fourpost::ChannelResponse& channel) {
  return {.sensor = channel.name,
          .unit = channel.unit,
          .frf = VectorOf(channel.response),
          .mean = VectorOf(channel.mean),
          .second_harmonic = VectorOf(channel.second_harmonic)};
}

/// Half a stroke is what the largest amplitude may take.
void CheckStrokes(const fourpost::Vehicle& vehicle, const SteppedSine& sine, const std::vector<double>& shape,
                  Diagnostics& found) {
  const double largest = *std::max_element(sine.amplitude_m.begin(), sine.amplitude_m.end());
  std::vector<double> excursion;
  for (const double share : shape) excursion.push_back(std::abs(share) * largest);
  CheckStroke(vehicle, excursion, sine.posts, found, sine.stroke_m);
}

}  // namespace

Excitation ExcitationOf(const fourpost::Vehicle& vehicle, const SteppedSine& sine) {
  RequireFinite("frequency_Hz", sine.frequency_Hz);
  RequireFinite("amplitude_m", sine.amplitude_m);
  Diagnostics found;
  Excitation excitation{.frequency_Hz = sine.frequency_Hz, .amplitude_m = sine.amplitude_m};
  excitation.shape = ReadPostShape(sine.posts, vehicle, found);
  if (sine.amplitude_m.size() == 1) excitation.amplitude_m.assign(sine.frequency_Hz.size(), sine.amplitude_m.front());
  if (excitation.amplitude_m.size() != sine.frequency_Hz.size())
    found.Report(kAmplitudeCount, {},
                 {std::to_string(sine.amplitude_m.size()), std::to_string(sine.frequency_Hz.size())});
  else if (!found.HasErrors() && !sine.amplitude_m.empty()) CheckStrokes(vehicle, sine, excitation.shape, found);
  if (found.HasErrors()) throw FaultyInput(found);
  return excitation;
}

Response ResponseOf(const FrequencyResponse& found, fourpost::Engine engine) {
  Response response{.frequency_Hz = found.frequency_Hz, .engine = PublicEngine(engine)};
  for (const fourpost::ChannelResponse& channel : found.channels) response.channels.push_back(ChannelOf(channel));
  return response;
}

Response ResponseOf(const SteadyResponse& answer) {
  Response response = ResponseOf(answer.response, answer.engine);
  if (answer.kinematics_error) {
    response.kinematics_error_dB = answer.kinematics_error->gain_dB.value;
    response.kinematics_error_deg = answer.kinematics_error->phase_deg.value;
  }
  return response;
}

SteppedSine UsualSine(const Vehicle& vehicle, const std::string& posts, const std::vector<double>& frequency_Hz) {
  return Guarded([&] {
    SteppedSine sine{.frequency_Hz = frequency_Hz, .posts = posts};
    if (frequency_Hz.empty()) {
      Diagnostics found;
      const std::optional<SweepRequest> request = ReadSweep({.modes = {posts}}, Inside::Of(vehicle), found);
      if (!request) throw FaultyInput(found);
      sine.frequency_Hz = request->sweeps.front().excitation.frequency_Hz;
    }
    for (const double frequency : sine.frequency_Hz) sine.amplitude_m.push_back(kUsualAmplitude.At(frequency));
    return sine;
  });
}

fourpost::Engine OwnEngine(Engine engine) {
  switch (engine) {
    case Engine::kAuto: return fourpost::Engine::kAuto;
    case Engine::kReduced: return fourpost::Engine::kReduced;
    case Engine::kFull: return fourpost::Engine::kFull;
    case Engine::kTimeIntegration: return fourpost::Engine::kTimeIntegration;
  }
  return fourpost::Engine::kAuto;
}

Engine PublicEngine(fourpost::Engine engine) {
  switch (engine) {
    case fourpost::Engine::kAuto: return Engine::kAuto;
    case fourpost::Engine::kReduced: return Engine::kReduced;
    case fourpost::Engine::kFull: return Engine::kFull;
    case fourpost::Engine::kTimeIntegration: return Engine::kTimeIntegration;
  }
  return Engine::kAuto;
}

const ChannelResponse& Response::At(const std::string& sensor) const {
  std::vector<std::string> known;
  for (const ChannelResponse& channel : channels) {
    if (channel.sensor == sensor) return channel;
    known.push_back(channel.sensor);
  }
  RefuseName("sensor", sensor, known);
}

Response Respond(const Vehicle& vehicle, const SteppedSine& excitation, Engine engine,
                 const std::function<bool()>& stop) {
  return Guarded([&] {
    const fourpost::Vehicle& own = Inside::Of(vehicle);
    const Excitation posts = ExcitationOf(own, excitation);
    SteadySolver solver(own);
    RequireStable(own, solver);
    const std::optional<SteadyResponse> answer =
        SolveSweep(solver, excitation.posts, posts, OwnEngine(engine), {}, {.stop = stop});
    if (!answer) throw SimulationError(kCallStopped);
    return ResponseOf(*answer);
  });
}

}  // namespace fourpost::api
