#include "vehicles/response/reduced_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "vehicles/simulation/condensed_system.h"

namespace fourpost {
namespace {

/// Speed within which the steepest friction turns round [m/s]; infinite without any.
double TurningSpeed(const CondensedModel& model) {
  double speed = std::numeric_limits<double>::infinity();
  for (const CondensedModel::Dashpot& dashpot : model.dashpots) speed = std::min(speed, dashpot.law.StepSpeed());
  return speed;
}

/// In which friction that sticks turns round at this acceleration [s]; infinite without any.
double TurningTime(const CondensedModel& model, double acceleration) {
  double time = std::numeric_limits<double>::infinity();
  for (const CondensedModel::Rubbing& friction : model.rubbings)
    if (friction.law.force > 0)
      time = std::min(time, std::sqrt(2 * friction.law.force / friction.law.stiffness / acceleration));
  return time;
}

/// Friction turns round within TurningSpeed over the acceleration, of some A w^2, and jumps in accelerations alias into
/// their harmonics: steps resolve the one, samples the other. 128 samples a cycle alone left 7e-3.
MarchedResponse MarchOne(const CondensedModel& model, const RigView& rig, const Excitation& one, MarchOptions options) {
  constexpr double kLongestStep_s = 2.5e-4;
  constexpr double kShortestStep_s = 2e-5;
  constexpr int kFewestSamples = 128;
  constexpr int kMostSamples = 512;
  const double frequency = one.frequency_Hz[0];
  const double acceleration = one.amplitude_m[0] * std::pow(2 * std::numbers::pi * frequency, 2);
  const double turning = std::min(0.5 * TurningSpeed(model) / acceleration, 0.2 * TurningTime(model, acceleration));
  const double step = std::clamp(turning, kShortestStep_s, kLongestStep_s);
  const double samples = std::clamp(1 / (frequency * kLongestStep_s), double{kFewestSamples}, double{kMostSamples});
  options.samples_per_cycle = static_cast<int>(samples);
  CondensedSystem system(model, rig, step);
  return March(system, one, options);
}

void Append(const MarchedResponse& one, MarchedResponse& all) {
  const auto append = [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(one.unsteady, all.unsteady);
  all.simulated_s += one.simulated_s;
  FrequencyResponse& response = all.response;
  if (response.channels.empty()) {
    response = one.response;
    return;
  }
  append(one.response.frequency_Hz, response.frequency_Hz);
  append(one.response.amplitude_m, response.amplitude_m);
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    append(one.response.channels[c].response, response.channels[c].response);
    append(one.response.channels[c].mean, response.channels[c].mean);
    append(one.response.channels[c].second_harmonic, response.channels[c].second_harmonic);
  }
}

}  // namespace

MarchedResponse MarchReduced(const CondensedModel& model, const RigView& rig, const Excitation& excitation,
                             const MarchOptions& options) {
  MarchedResponse all;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i)
    Append(MarchOne(model, rig, {{excitation.frequency_Hz[i]}, {excitation.amplitude_m[i]}, excitation.shape}, options),
           all);
  return all;
}

}  // namespace fourpost
