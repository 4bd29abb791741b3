#include "vehicles/response/friction_lock.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {
namespace {

/// Extension amplitude over that at which friction begins to slide, per metre.
double SlidingPerMetre(const Damper& damper, std::span<const double> values, double omega) {
  const DashpotDescription::Friction& friction = *damper.law.friction;
  const double force = friction.force.At(values);
  // The friction of a hydraulic damper acts beside its mount.
  if (damper.series && !damper.hydraulic) return damper.series->At(values).Slope(0) / force;
  return omega / friction.speed.At(values);
}

/// A strut sensor on each damper with friction, in place of the vehicle's own sensors.
Vehicle WithProbes(Vehicle vehicle, const std::vector<std::size_t>& dampers) {
  vehicle.sensors.clear();
  for (const std::size_t i : dampers)
    vehicle.sensors.push_back(
        {.name = vehicle.dampers[i].name, .type = Sensor::Type::kStrut, .line = vehicle.dampers[i].line});
  return vehicle;
}

LockedFriction NearestToSliding(const Vehicle& vehicle, std::size_t index, const ChannelResponse& extension,
                                const PeriodicResponse& found) {
  const std::vector<double> values = vehicle.ParameterValues();
  const Damper& damper = vehicle.dampers[index];
  LockedFriction lock{.damper = index, .friction_N = damper.law.friction->force.At(values)};
  double most = 0;
  for (std::size_t i = 0; i < extension.response.size(); ++i) {
    const double frequency = found.response.frequency_Hz[i];
    if (std::find(found.unconverged_Hz.begin(), found.unconverged_Hz.end(), frequency) != found.unconverged_Hz.end())
      continue;
    const double sliding = std::abs(extension.response[i]) * found.response.amplitude_m[i] *
                           SlidingPerMetre(damper, values, 2 * std::numbers::pi * frequency);
    if (sliding <= most) continue;
    most = sliding;
    lock.frequency_Hz = frequency;
  }
  lock.factor = 1 / most;
  return lock;
}

}  // namespace

std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Excitation& excitation) {
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<std::size_t> rubbing;
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    if (vehicle.dampers[i].law.friction && vehicle.dampers[i].law.friction->force.At(values) > 0) rubbing.push_back(i);
  if (rubbing.empty()) return {};
  const Vehicle probed = WithProbes(vehicle, rubbing);
  // Whether it slides is told by few harmonics.
  const PeriodicResponse found =
      SolveHarmonicBalance(CondensedVehicle(probed).At(values), probed.sensors, excitation, {.error = 0.1});
  std::vector<LockedFriction> locked;
  for (std::size_t k = 0; k < rubbing.size(); ++k) {
    const LockedFriction lock = NearestToSliding(vehicle, rubbing[k], found.response.channels[k], found);
    // Ten thousand times the motion: none of it reaches this damper.
    if (lock.factor > 1 && lock.factor < 1e4) locked.push_back(lock);
  }
  return locked;
}

}  // namespace fourpost
