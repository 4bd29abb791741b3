#include "vehicles/multibody/line_forces.h"

namespace fourpost {
namespace {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector_;

}  // namespace

void SpringForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                            SimTK::Vector&) const {
  const LineMotion motion = Motion(data_.line, state);
  ApplyTension(data_.line, state, motion, data_.preload + data_.law.Force(motion.extension), body_forces);
}

SimTK::Real SpringForce::calcPotentialEnergy(const State& state) const {
  const double extension = Extension(data_.line, state);
  return data_.preload * extension + data_.law.Energy(extension);
}

double DamperForce::SeriesExtension(const State& state) const { return forces_.getZ(state)[series_extension_]; }

void DamperForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                            SimTK::Vector&) const {
  const LineMotion motion = Motion(data_.line, state);
  const double tension =
      data_.in_series ? data_.series.Force(SeriesExtension(state)) : data_.dashpot.Force(motion.rate);
  ApplyTension(data_.line, state, motion, tension, body_forces);
}

SimTK::Real DamperForce::calcPotentialEnergy(const State& state) const {
  return data_.in_series ? data_.series.Energy(SeriesExtension(state)) : 0;
}

void DamperForce::realizeTopology(State& state) const {
  if (data_.in_series) series_extension_ = forces_.allocateZ(state, SimTK::Vector(1, SimTK::Real(0)));
}

void DamperForce::realizeAcceleration(const State& state) const {
  if (!data_.in_series) return;
  // Not a SeriesDamper: that would copy the law's curve.
  const double tension = data_.series.Force(SeriesExtension(state));
  forces_.updZDot(state)[series_extension_] = Motion(data_.line, state).rate - data_.dashpot.Velocity(tension);
}

std::array<double, 2> HydraulicRates(const HydraulicData& data, const LineMotion& motion,
                                     const std::array<double, 2>& states) {
  std::array<double, 2> pressures = data.damper.damper.Rest();
  for (std::size_t i = 0; i < 2; ++i) pressures[i] += kHydraulicPressureUnit * states[i];
  std::array<double, 2> rates = data.is_mounted
                                    ? data.damper.PressureRates(motion.extension, motion.rate, pressures)
                                    : data.damper.damper.PressureRates(motion.extension, motion.rate, pressures);
  for (double& rate : rates) rate /= kHydraulicPressureUnit;
  return rates;
}

std::array<double, 2> HydraulicForce::Pressures(const State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  std::array<double, 2> pressures = data_.damper.damper.Rest();
  pressures[0] += kHydraulicPressureUnit * z[pressures_];
  pressures[1] += kHydraulicPressureUnit * z[SimTK::ZIndex(pressures_ + 1)];
  return pressures;
}

void HydraulicForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                               SimTK::Vector&) const {
  const LineMotion motion = Motion(data_.line, state);
  ApplyTension(data_.line, state, motion, data_.damper.damper.Force(motion.rate, Pressures(state)), body_forces);
}

SimTK::Real HydraulicForce::calcPotentialEnergy(const State& state) const {
  const double extension = Extension(data_.line, state);
  return data_.is_mounted ? data_.damper.Energy(extension, Pressures(state))
                          : data_.damper.damper.Energy(extension, Pressures(state));
}

void HydraulicForce::realizeTopology(State& state) const {
  pressures_ = forces_.allocateZ(state, SimTK::Vector(2, SimTK::Real(0)));
}

void HydraulicForce::realizeAcceleration(const State& state) const {
  const SimTK::Vector& z = forces_.getZ(state);
  const SimTK::ZIndex second(pressures_ + 1);
  const std::array<double, 2> rates = HydraulicRates(data_, Motion(data_.line, state), {z[pressures_], z[second]});
  forces_.updZDot(state)[pressures_] = rates[0];
  forces_.updZDot(state)[second] = rates[1];
}

double FrictionRate(const FrictionData& data, const LineMotion& motion, double state) {
  const double force = data.law.force;
  return force == 0 ? 0 : data.law.Rate(motion.rate, force * state) / force;
}

void FrictionForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                              SimTK::Vector&) const {
  ApplyTension(data_.line, state, Motion(data_.line, state), data_.law.force * forces_.getZ(state)[tension_],
               body_forces);
}

SimTK::Real FrictionForce::calcPotentialEnergy(const State& state) const {
  const double tension = data_.law.force * forces_.getZ(state)[tension_];
  return 0.5 * tension * tension / data_.law.stiffness;
}

void FrictionForce::realizeTopology(State& state) const {
  tension_ = forces_.allocateZ(state, SimTK::Vector(1, SimTK::Real(0)));
}

void FrictionForce::realizeAcceleration(const State& state) const {
  forces_.updZDot(state)[tension_] = FrictionRate(data_, Motion(data_.line, state), forces_.getZ(state)[tension_]);
}

void AntiRollForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                              SimTK::Vector&) const {
  const LineMotion left = Motion(data_.left, state);
  const LineMotion right = Motion(data_.right, state);
  const double tension =
      data_.stiffness * (left.extension - right.extension) + data_.damping * (left.rate - right.rate);
  ApplyTension(data_.left, state, left, tension, body_forces);
  ApplyTension(data_.right, state, right, -tension, body_forces);
}

SimTK::Real AntiRollForce::calcPotentialEnergy(const State& state) const {
  const double difference = Extension(data_.left, state) - Extension(data_.right, state);
  return 0.5 * data_.stiffness * difference * difference;
}

void ActuatorForce::calcForce(const State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                              SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const {
  ApplyTension(line_, state, Motion(line_, state), platforms_(state.getTime())[index_].height, body_forces);
}

}  // namespace fourpost
