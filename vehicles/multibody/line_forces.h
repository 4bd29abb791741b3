#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "vehicles/description/post_motion.h"
#include "vehicles/laws/dahl_friction.h"
#include "vehicles/laws/dashpot_law.h"
#include "vehicles/laws/mounted_hydraulic_damper.h"
#include "vehicles/laws/series_damper.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/multibody/body_line.h"
#include "vehicles/multibody/simbody.h"

namespace fourpost {

// Inputs of the elements' force computation; changed between evaluations, never during one.

struct SpringData {
  BodyLine line;
  SpringLaw law;
  double preload = 0;
};

struct DamperData {
  BodyLine line;
  DashpotLaw dashpot;
  bool in_series = false;
  SpringLaw series;
};

struct HydraulicData {
  BodyLine line;
  MountedHydraulicDamper damper;
  /// Whether there is a mount.
  bool is_mounted = false;
};

struct FrictionData {
  BodyLine line;
  DahlFriction law;
};

struct AntiRollData {
  BodyLine left;
  BodyLine right;
  double stiffness = 0;
  double damping = 0;
};

/// Tension = preload + law of the extension.
class SpringForce : public SimTK::Force::Custom::Implementation {
 public:
  explicit SpringForce(const SpringData& data) : data_(data) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

 private:
  const SpringData& data_;
};

/// Dashpot alone, or in series with a spring whose extension is a state of its own.
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

/// Hydraulic damper; its states are the two chamber pressures above rest, in kHydraulicPressureUnit.
class HydraulicForce : public SimTK::Force::Custom::Implementation {
 public:
  HydraulicForce(const HydraulicData& data, const SimTK::GeneralForceSubsystem& forces)
      : data_(data), forces_(forces) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;
  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;

 private:
  std::array<double, 2> Pressures(const SimTK::State& state) const;

  const HydraulicData& data_;
  const SimTK::GeneralForceSubsystem& forces_;
  mutable SimTK::ZIndex pressures_;
};

/// Unit in which states of the integration are about 1 in size [Pa].
inline constexpr double kHydraulicPressureUnit = 1e6;

/// Rates of a hydraulic damper's states as a function of its states [kHydraulicPressureUnit, kHydraulicPressureUnit/s].
std::array<double, 2> HydraulicRates(const HydraulicData& data, const LineMotion& motion,
                                     const std::array<double, 2>& states);

/// Friction that sticks; its state is the tension over the sliding force.
class FrictionForce : public SimTK::Force::Custom::Implementation {
 public:
  FrictionForce(const FrictionData& data, const SimTK::GeneralForceSubsystem& forces) : data_(data), forces_(forces) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  /// tension^2 / 2 stiffness: of the power that it takes up, |v| tension^2 / force is lost, the rest is its rate.
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;
  void realizeTopology(SimTK::State& state) const override;
  void realizeAcceleration(const SimTK::State& state) const override;

 private:
  const FrictionData& data_;
  const SimTK::GeneralForceSubsystem& forces_;
  mutable SimTK::ZIndex tension_;
};

/// Rate of its state [1/s].
double FrictionRate(const FrictionData& data, const LineMotion& motion, double state);

/// Tension that is given over time.
class ActuatorForce : public SimTK::Force::Custom::Implementation {
 public:
  /// `index`: of the tension among the platforms, see PostMotion.
  ActuatorForce(const BodyLine& line, std::size_t index, const std::function<const Platforms&(double t)>& platforms)
      : line_(line), index_(index), platforms_(platforms) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
  const BodyLine& line_;
  std::size_t index_;
  const std::function<const Platforms&(double t)>& platforms_;
};

/// Anti-roll bar: tension on the left line = stiffness (e_left - e_right) + damping (e_left - e_right)', opposite on
/// the right one.
class AntiRollForce : public SimTK::Force::Custom::Implementation {
 public:
  explicit AntiRollForce(const AntiRollData& data) : data_(data) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

 private:
  const AntiRollData& data_;
};

}  // namespace fourpost
