#include "vehicles/multibody/body_line.h"

namespace fourpost {
namespace {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

Vec3 Axis(const BodyLine& line, const State& state) { return line.parent.getBodyRotation(state) * line.axis; }

}  // namespace

void ApplyTension(const BodyLine& line, const State& state, const LineMotion& motion, double tension,
                  SimTK::Vector_<SpatialVec>& body_forces) {
  const Vec3 force = tension * motion.pull;
  line.child.applyForceToBodyPoint(state, line.child.findStationAtGroundPoint(state, motion.on_child), force,
                                   body_forces);
  line.parent.applyForceToBodyPoint(state, line.parent.findStationAtGroundPoint(state, motion.on_parent), -force,
                                    body_forces);
}

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

}  // namespace fourpost
