#pragma once

#include <functional>
#include <span>
#include <vector>

#include "vehicles/damper_law.h"
#include "vehicles/simbody.h"

namespace fourpost {

/// A ForceLine between two Simbody bodies; its law is told in vehicle.h.
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
  /// Where a tension acts, and its direction on the child; the parent feels the opposite at `on_parent`.
  SimTK::Vec3 on_child;
  SimTK::Vec3 on_parent;
  SimTK::Vec3 pull;
};

double Length(const BodyLine& line, const SimTK::State& state);
/// Needs Stage::Position.
double Extension(const BodyLine& line, const SimTK::State& state);
/// Needs Stage::Velocity.
LineMotion Motion(const BodyLine& line, const SimTK::State& state);

// What the elements read while they compute; changed between evaluations, never during one.

struct SpringData {
  BodyLine line;
  double stiffness = 0;
  double preload = 0;
};

struct DamperData {
  BodyLine line;
  BilinearDashpot dashpot;
  bool in_series = false;
  double series_stiffness = 0;
};

struct TyreData {
  SimTK::MobilizedBody body;
  SimTK::Vec3 station;
  double design_height = 0;
  double stiffness = 0;
  double damping = 0;
  double preload = 0;
  /// Index of the post under the tyre; -1 for a platform at rest.
  int post = -1;
};

struct PlatformState {
  std::vector<double> height;
  std::vector<double> velocity;
};

/// Tension = preload + stiffness times extension.
class SpringForce : public SimTK::Force::Custom::Implementation {
 public:
  explicit SpringForce(const SpringData& data) : data_(data) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

 private:
  const SpringData& data_;
};

/// Bilinear dashpot alone, or in line with a spring whose extension is a state of its own.
class DamperForce : public SimTK::Force::Custom::Implementation {
 public:
  DamperForce(const DamperData& data, const SimTK::GeneralForceSubsystem& forces) : data_(data), forces_(forces) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;
  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;

 private:
  double SeriesExtension(const SimTK::State& state) const;

  const DamperData& data_;
  const SimTK::GeneralForceSubsystem& forces_;
  mutable SimTK::ZIndex series_extension_;
};

/// Compression = preload + stiffness times squeeze + damping times its rate, vertical on the body.
class TyreForce : public SimTK::Force::Custom::Implementation {
 public:
  TyreForce(const TyreData& data, const std::function<const PlatformState&(double t)>& platforms)
      : data_(data), platforms_(platforms) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

  /// Change of the compression from the design pose [N]. Needs Stage::Velocity.
  static double DynamicCompression(const TyreData& data, const PlatformState& platforms, const SimTK::State& state);

 private:
  const TyreData& data_;
  const std::function<const PlatformState&(double t)>& platforms_;
};

}  // namespace fourpost
