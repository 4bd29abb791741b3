#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/modes.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/ride/chassis_numbers.h"
#include "vehicles/ride/observability.h"
#include "vehicles/ride/ride_geometry.h"
#include "vehicles/ride/suspension.h"

namespace fourpost {

/// Summary of a vehicle for checking its description, at one set of parameter values; SI, design pose, ground axes.
struct VehicleSummary {
  struct CornerLoad {
    std::string tyre;
    double load_N = 0;
  };

  int dof = 0;
  /// Of all that moves: mass, its centre [m], inertia about it [kg m^2].
  double mass_kg = 0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Suspension suspension;
  /// Static, in the order of Vehicle::tyres.
  std::vector<CornerLoad> corner_loads;
  /// Static tension of each spring [N], in the order of Vehicle::springs.
  std::vector<double> spring_tension;
  RideGeometry ride;
  ChassisNumbers chassis;
  /// Friction that sticks is taken as sliding.
  std::vector<Mode> modes;
  /// The same while all such friction sticks; empty for a vehicle without any.
  std::vector<Mode> stuck_modes;
  /// Largest real part of all poles, oscillating or not [1/s]: above zero the design pose is unstable.
  double growth_rate = 0;
  /// One per free parameter.
  std::vector<ParameterView> views;

  double Weight_N() const;
  /// Sum of the tyre loads.
  double TyreLoad_N() const;
  /// Mass without the unsprung mass; empty if unknown.
  std::optional<double> SprungMass_kg() const;
  bool IsStable() const { return growth_rate < kSlowestMotion_per_s; }
};

/// Throws FaultyInput if the vehicle cannot be assembled or held in its design pose.
VehicleSummary Summarise(const Vehicle& vehicle, std::span<const double> parameters);

}  // namespace fourpost
