#include <fourpost/response.h>

#include "identify/api/engine_names.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/api/inside.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/requests/post_shape.h"
#include "vehicles/requests/solve_sweep.h"

namespace fourpost::api {
namespace {

Excitation ExcitationOf(const Vehicle& vehicle, const SteppedSine& sine) {
  Diagnostics found;
  Excitation excitation{.frequency_Hz = sine.frequency_Hz, .amplitude_m = sine.amplitude_m};
  excitation.shape = ReadPostShape(sine.posts, Inside::Of(vehicle), found);
  if (sine.amplitude_m.size() == 1) excitation.amplitude_m.assign(sine.frequency_Hz.size(), sine.amplitude_m.front());
  if (excitation.amplitude_m.size() != sine.frequency_Hz.size())
    found.Report(kAmplitudeCount, {},
                 {std::to_string(sine.amplitude_m.size()), std::to_string(sine.frequency_Hz.size())});
  if (found.HasErrors()) throw FaultyInput(found);
  return excitation;
}

Eigen::VectorXd Vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

ChannelResponse ChannelOf(const fourpost::ChannelResponse& channel) {
  return {.sensor = channel.name,
          .unit = channel.unit,
          .frf = Eigen::Map<const Eigen::VectorXcd>(channel.response.data(),
                                                    static_cast<Eigen::Index>(channel.response.size())),
          .mean = Vector(channel.mean),
          .second_harmonic = Vector(channel.second_harmonic)};
}

}  // namespace

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

Response Respond(const Vehicle& vehicle, const SteppedSine& excitation, Engine engine) {
  return Guarded([&] {
    SteadySolver solver(Inside::Of(vehicle));
    RequireStable(Inside::Of(vehicle), solver);
    const SteadyResponse answer = solver.Solve(ExcitationOf(vehicle, excitation), OwnEngine(engine));
    Response response{.frequency_Hz = answer.response.frequency_Hz, .engine = PublicEngine(answer.engine)};
    for (const fourpost::ChannelResponse& channel : answer.response.channels)
      response.channels.push_back(ChannelOf(channel));
    if (answer.kinematics_error) {
      response.kinematics_error_dB = answer.kinematics_error->gain_dB.value;
      response.kinematics_error_deg = answer.kinematics_error->phase_deg.value;
    }
    return response;
  });
}

}  // namespace fourpost::api
