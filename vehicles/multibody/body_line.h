#pragma once

#include "vehicles/multibody/simbody.h"

namespace fourpost {

/// A ForceLine between two Simbody bodies; vehicle.h defines its law.
struct BodyLine {
  SimTK::MobilizedBody parent;
  SimTK::MobilizedBody child;
  SimTK::Vec3 parent_station;
  SimTK::Vec3 child_station;
  bool guided = false;
  /// In parent axes, when guided.
  SimTK::Vec3 axis;
  /// Length in the design pose [m].
  double design_length = 0;
};

/// A line at one instant, in ground axes.
struct LineMotion {
  /// Extension from the design pose [m] and its rate [m/s], rebound positive.
  double extension = 0;
  double rate = 0;
  /// Point of action of a tension, and its direction on the child; the opposite force acts on the parent at
  /// `on_parent`.
  SimTK::Vec3 on_child;
  SimTK::Vec3 on_parent;
  SimTK::Vec3 pull;
};

double Length(const BodyLine& line, const SimTK::State& state);
/// Needs Stage::Position.
double Extension(const BodyLine& line, const SimTK::State& state);
/// Needs Stage::Velocity.
LineMotion Motion(const BodyLine& line, const SimTK::State& state);

/// Adds a tension along the line to the forces on its two bodies.
void ApplyTension(const BodyLine& line, const SimTK::State& state, const LineMotion& motion, double tension,
                  SimTK::Vector_<SimTK::SpatialVec>& body_forces);

}  // namespace fourpost
