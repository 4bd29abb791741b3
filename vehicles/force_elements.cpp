#include "vehicles/force_elements.h"

namespace fourpost {
namespace {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector_;

Vec3 Axis(const BodyLine& line, const State& state) { return line.parent.getBodyRotation(state) * line.axis; }

void ApplyTension(const BodyLine& line, const State& state, const LineMotion& motion, double tension,
                  Vector_<SpatialVec>& body_forces) {
  const Vec3 force = tension * motion.pull;
  line.child.applyForceToBodyPoint(state, line.child.findStationAtGroundPoint(state, motion.on_child), force,
                                   body_forces);
  line.parent.applyForceToBodyPoint(state, line.parent.findStationAtGroundPoint(state, motion.on_parent), -force,
                                    body_forces);
}

double Squeeze(const TyreData& data, const PlatformState& platforms, const State& state) {
  const double height = data.body.findStationLocationInGround(state, data.station)[2] - data.design_height;
  return data.post < 0 ? -height : platforms.height[static_cast<std::size_t>(data.post)] - height;
}

double SqueezeRate(const TyreData& data, const PlatformState& platforms, const State& state) {
  const double velocity = data.body.findStationVelocityInGround(state, data.station)[2];
  return data.post < 0 ? -velocity : platforms.velocity[static_cast<std::size_t>(data.post)] - velocity;
}

}  // namespace

double Length(const BodyLine& line, const State& state) {
  const Vec3 span = line.parent.findStationLocationInGround(state, line.parent_station) -
                    line.child.findStationLocationInGround(state, line.child_station);
  return line.guided ? SimTK::dot(Axis(line, state), span) : span.norm();
}

double Extension(const BodyLine& line, const State& state) { return Length(line, state) - line.design_length; }

LineMotion Motion(const BodyLine& line, const State& state) {
  const Vec3 parent = line.parent.findStationLocationInGround(state, line.parent_station);
  const Vec3 child = line.child.findStationLocationInGround(state, line.child_station);
  const Vec3 span = parent - child;
  const double length = line.guided ? SimTK::dot(Axis(line, state), span) : span.norm();

  LineMotion motion;
  motion.on_child = child;
  motion.on_parent = line.guided ? child : parent;
  motion.pull = line.guided ? Axis(line, state) : span / length;
  motion.extension = length - line.design_length;
  const Vec3 parent_velocity =
      line.parent.findStationVelocityInGround(state, line.parent.findStationAtGroundPoint(state, motion.on_parent));
  const Vec3 child_velocity = line.child.findStationVelocityInGround(state, line.child_station);
  motion.rate = SimTK::dot(motion.pull, parent_velocity - child_velocity);
  return motion;
}

void SpringForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                            SimTK::Vector&) const {
  const LineMotion motion = Motion(data_.line, state);
  ApplyTension(data_.line, state, motion, data_.preload + data_.stiffness * motion.extension, body_forces);
}

SimTK::Real SpringForce::calcPotentialEnergy(const State& state) const {
  const double extension = Extension(data_.line, state);
  return data_.preload * extension + 0.5 * data_.stiffness * extension * extension;
}

double DamperForce::SeriesExtension(const State& state) const { return forces_.getZ(state)[series_extension_]; }

void DamperForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&,
                            SimTK::Vector&) const {
  const LineMotion motion = Motion(data_.line, state);
  const double tension = data_.in_series
                             ? SeriesDamper{data_.dashpot, data_.series_stiffness}.Force(SeriesExtension(state))
                             : data_.dashpot.Force(motion.rate);
  ApplyTension(data_.line, state, motion, tension, body_forces);
}

SimTK::Real DamperForce::calcPotentialEnergy(const State& state) const {
  if (!data_.in_series) return 0;
  const double extension = SeriesExtension(state);
  return 0.5 * data_.series_stiffness * extension * extension;
}

void DamperForce::realizeTopology(State& state) const {
  if (data_.in_series) series_extension_ = forces_.allocateZ(state, SimTK::Vector(1, SimTK::Real(0)));
}

void DamperForce::realizeAcceleration(const State& state) const {
  if (!data_.in_series) return;
  const SeriesDamper damper{data_.dashpot, data_.series_stiffness};
  forces_.updZDot(state)[series_extension_] = damper.SpringRate(Motion(data_.line, state).rate, SeriesExtension(state));
}

double TyreForce::DynamicCompression(const TyreData& data, const PlatformState& platforms, const State& state) {
  return data.stiffness * Squeeze(data, platforms, state) + data.damping * SqueezeRate(data, platforms, state);
}

void TyreForce::calcForce(const State& state, Vector_<SpatialVec>& body_forces, Vector_<Vec3>&, SimTK::Vector&) const {
  const double compression = data_.preload + DynamicCompression(data_, platforms_(state.getTime()), state);
  data_.body.applyForceToBodyPoint(state, data_.station, Vec3(0, 0, compression), body_forces);
}

SimTK::Real TyreForce::calcPotentialEnergy(const State& state) const {
  const double squeeze = Squeeze(data_, platforms_(state.getTime()), state);
  return data_.preload * squeeze + 0.5 * data_.stiffness * squeeze * squeeze;
}

}  // namespace fourpost
