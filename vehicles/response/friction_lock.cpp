#include "vehicles/response/friction_lock.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "analysis/text/count_check.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {
namespace {

/// Ten thousand times the motion: none of it reaches the damper.
constexpr double kNotReached = 1e4;

/// Extension over that at which friction begins to slide, where e, with a mount or with friction that sticks, or v
/// shows that.
double Sliding(const Damper& damper, std::span<const double> values, double extension, double rate) {
  const DashpotDescription::Friction& friction = *damper.law.friction;
  if (friction.stiffness) return friction.stiffness->At(values) * extension / friction.force.At(values);
  // The friction of a hydraulic damper acts beside its mount.
  if (damper.series && !damper.hydraulic)
    return damper.series->At(values).Slope(0) * extension / friction.force.At(values);
  return rate / friction.speed.At(values);
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
    const double amplitude = std::abs(extension.response[i]) * found.response.amplitude_m[i];
    const double sliding = Sliding(damper, values, amplitude, 2 * std::numbers::pi * frequency * amplitude);
    if (sliding <= most) continue;
    most = sliding;
    lock.frequency_Hz = frequency;
  }
  lock.factor = 1 / most;
  return lock;
}

}  // namespace

std::vector<std::size_t> RubbingDampers(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<std::size_t> rubbing;
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    if (vehicle.dampers[i].law.friction && vehicle.dampers[i].law.friction->force.At(values) > 0) rubbing.push_back(i);
  return rubbing;
}

std::vector<Sensor> ExtensionSensors(const Vehicle& vehicle, const std::vector<std::size_t>& dampers) {
  std::vector<Sensor> sensors;
  for (const std::size_t i : dampers)
    sensors.push_back({.name = "extension of " + vehicle.dampers[i].name,
                       .type = Sensor::Type::kStrut,
                       .line = vehicle.dampers[i].line});
  return sensors;
}

std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Excitation& excitation) {
  const std::vector<std::size_t> rubbing = RubbingDampers(vehicle);
  if (rubbing.empty()) return {};
  Vehicle probed = vehicle;
  probed.sensors = ExtensionSensors(vehicle, rubbing);
  // Whether it slides shows in few harmonics.
  const PeriodicResponse found = SolveHarmonicBalance(CondensedVehicle(probed).At(vehicle.ParameterValues()),
                                                      probed.sensors, excitation, {.error = 0.1});
  std::vector<LockedFriction> locked;
  for (std::size_t k = 0; k < rubbing.size(); ++k) {
    const LockedFriction lock = NearestToSliding(vehicle, rubbing[k], found.response.channels[k], found);
    if (lock.factor > 1 && lock.factor < kNotReached) locked.push_back(lock);
  }
  return locked;
}

std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Eigen::MatrixXd& extensions,
                                               double rate_Hz) {
  const std::vector<double> values = vehicle.ParameterValues();
  const std::vector<std::size_t> rubbing = RubbingDampers(vehicle);
  RequireCount("FindLockedFriction: extensions", "dampers with friction", rubbing.size(),
               static_cast<std::size_t>(extensions.cols()));
  std::vector<LockedFriction> locked;
  for (std::size_t k = 0; k < rubbing.size() && extensions.rows() > 1; ++k) {
    const auto extension = extensions.col(static_cast<Eigen::Index>(k));
    const Eigen::Index steps = extension.size() - 1;
    const double rate = rate_Hz * (extension.tail(steps) - extension.head(steps)).cwiseAbs().maxCoeff();
    const Damper& damper = vehicle.dampers[rubbing[k]];
    const double factor = 1 / Sliding(damper, values, extension.cwiseAbs().maxCoeff(), rate);
    if (factor > 1 && factor < kNotReached)
      locked.push_back({.damper = rubbing[k], .friction_N = damper.law.friction->force.At(values), .factor = factor});
  }
  return locked;
}

}  // namespace fourpost
