#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/post_motion.h"
#include "vehicles/laws/tyre_law.h"
#include "vehicles/multibody/simbody.h"

namespace fourpost {

// Inputs of the elements' force computation; changed between evaluations, never during one.

struct BushingData {
  SimTK::MobilizedBody parent;
  SimTK::MobilizedBody child;
  SimTK::Vec3 parent_station;
  SimTK::Vec3 child_station;
  /// Axes of the bushing in the parent, and axes of the child that lie along them in the design pose.
  Eigen::Matrix3d parent_axes;
  Eigen::Matrix3d child_axes;
  /// Of the child's point in the bushing's axes, design pose.
  Eigen::Vector3d design_place;
  std::array<double, 6> stiffness{};
  std::array<double, 6> damping{};
  /// Along the bushing's axes: its force in the design pose [N].
  Eigen::Vector3d preload = Eigen::Vector3d::Zero();
};

/// A bushing at one instant; displacement x, y, z, then turn about x, y, z, see Bushing.
struct BushingMotion {
  Eigen::Matrix<double, 6, 1> displacement;
  Eigen::Matrix<double, 6, 1> rate;
  /// From bushing to ground axes, and the turn's rate per relative angular velocity in bushing axes.
  Eigen::Matrix3d axes;
  Eigen::Matrix3d turn_rate;
};

/// Needs Stage::Velocity.
BushingMotion Motion(const BushingData& data, const SimTK::State& state);
/// Sets the design pose to the present pose. Needs Stage::Position.
void MeasureDesign(BushingData& data, const SimTK::State& state);

/// Six linear springs and dampers.
class BushingForce : public SimTK::Force::Custom::Implementation {
 public:
  explicit BushingForce(const BushingData& data) : data_(data) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

 private:
  const BushingData& data_;
};

struct TyreData {
  SimTK::MobilizedBody body;
  SimTK::Vec3 station;
  double radius = 0;
  /// Of the foot [m].
  Eigen::Vector3d design_place = Eigen::Vector3d::Zero();
  /// With the preload.
  LoadedTyre vertical = {};
  double damping = 0;
  double lateral = 0;
  double longitudinal = 0;
  double lateral_damping = 0;
  double longitudinal_damping = 0;
  bool lifts_off = false;
  /// Index of the post under the tyre; -1 for a platform at rest.
  int post = -1;
};

/// Sets the design pose to the present pose. Needs Stage::Position.
void MeasureDesign(TyreData& data, const SimTK::State& state);

/// Force of the platform on the foot, see Tyre. When a tyre lifts off, only the vertical force goes to zero. Springs in
/// the plane that fade with the load would return more energy than they took to a foot that moves aside while lifted
/// and returns after landing; a foot that slips and lands elsewhere needs states of its own.
class TyreForce : public SimTK::Force::Custom::Implementation {
 public:
  TyreForce(const TyreData& data, const std::function<const Platforms&(double t)>& platforms)
      : data_(data), platforms_(platforms) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>& particle_forces, SimTK::Vector& mobility_forces) const override;
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

  /// Vertical force on the platform [N]. Needs Stage::Velocity.
  static double Compression(const TyreData& data, const Platforms& platforms, const SimTK::State& state);

 private:
  const TyreData& data_;
  const std::function<const Platforms&(double t)>& platforms_;
};

}  // namespace fourpost
