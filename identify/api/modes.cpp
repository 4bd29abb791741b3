#include <fourpost/modes.h>

#include <cstddef>
#include <numbers>

#include "identify/api/errors.h"
#include "identify/api/inside.h"
#include "identify/api/vectors.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/mode_times.h"
#include "vehicles/condensed/state_space.h"
#include "vehicles/ride/findings.h"
#include "vehicles/ride/pole_path.h"
#include "vehicles/ride/shaped_modes.h"
#include "vehicles/ride/stability.h"

namespace fourpost::api {
namespace {

/// Throws std::invalid_argument for values that do not go together.
CondensedModel ModelAtValues(const fourpost::Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  for (const Damper& damper : vehicle.dampers)
    if (damper.hydraulic) damper.HydraulicAt(values).Validate();
  return CondensedVehicle(vehicle).At(values);
}

Mode PublicMode(const ShapedMode& shaped) {
  const fourpost::Mode& mode = shaped.mode;
  Mode found{.name = mode.name,
             .kind = KindName(mode.kind),
             .frequency_Hz = mode.frequency_Hz,
             .damped_frequency_Hz = mode.pole.imag() / (2 * std::numbers::pi),
             .damping_ratio = mode.damping_ratio,
             .rise_time_s = RiseTime_s(mode),
             .settling_time_s = SettlingTime_s(mode),
             .poles = PolesOf(mode)};
  for (const MotionShare& part : mode.energy) found.kinetic_energy[part.motion] = part.share;
  for (const fourpost::BodyShape& body : shaped.shape)
    found.shape.push_back({.body = body.body, .translation = body.translation, .rotation = body.rotation});
  return found;
}

StateSpace PublicStateSpace(const Vehicle& vehicle, const CondensedModel& model) {
  const fourpost::StateSpace space(model);
  StateSpace found{.posts = vehicle.posts(),
                   .a = space.a,
                   .b = space.b,
                   .c = space.c,
                   .d = space.d,
                   .d_rate = space.d_rate,
                   .d_acceleration = space.d_acceleration};
  for (const Sensor& sensor : vehicle.sensors()) found.sensors.push_back(sensor.name);
  return found;
}

std::size_t PlaceOf(const fourpost::Vehicle& vehicle, const std::string& name) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    if (vehicle.parameters[i].name == name) return i;
    known.push_back(vehicle.parameters[i].name);
  }
  RefuseName("parameter", name, known);
}

}  // namespace

Modes FindModes(const Vehicle& vehicle) {
  return Guarded([&] {
    const fourpost::Vehicle& own = Inside::Of(vehicle);
    const CondensedModel model = ModelAtValues(own);
    Diagnostics findings;
    if (const std::optional<Growth> growth = GrowthOf(own, model))
      findings.Report(kUnstableInDesignPose, {own.file}, {growth->Text()});
    Modes found{.modes = {}, .state_space = PublicStateSpace(vehicle, model), .warnings = FindingsOf(findings)};
    for (const ShapedMode& shaped : ShapedModes(own, model)) found.modes.push_back(PublicMode(shaped));
    return found;
  });
}

std::vector<PolePath> FollowPoles(const Vehicle& vehicle, const std::string& parameter,
                                  const std::vector<double>& values) {
  return Guarded([&] {
    const fourpost::Vehicle& own = Inside::Of(vehicle);
    const std::size_t place = PlaceOf(own, parameter);
    Vehicle tried = vehicle;
    for (const double value : values) tried.Set(parameter, value);
    std::vector<PolePath> found;
    for (const fourpost::PolePath& path : fourpost::FollowPoles(own, place, values).paths)
      found.push_back({.mode = path.mode, .poles = VectorOf(path.pole)});
    return found;
  });
}

}  // namespace fourpost::api
