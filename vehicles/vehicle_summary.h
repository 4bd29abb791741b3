#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/modes.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// What an engineer checks a description by, at one set of parameter values; SI.
struct VehicleSummary {
  struct CornerLoad {
    std::string tyre;
    double load_N = 0;
  };

  int dof = 0;
  /// Of all moving links.
  double mass_kg = 0;
  /// In ground axes, design pose [m].
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// Static, in the order of Vehicle::tyres.
  std::vector<CornerLoad> corner_loads;
  std::vector<Mode> modes;
  /// Largest real part of all poles, oscillating or not [1/s]: above zero the design pose is unstable.
  double growth_rate = 0;
};

/// Throws FaultyInput when the vehicle cannot be assembled or held in its design pose.
VehicleSummary Summarise(const Vehicle& vehicle, std::span<const double> parameters);

}  // namespace fourpost
