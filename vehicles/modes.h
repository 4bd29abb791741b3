#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "vehicles/condensed_model.h"
#include "vehicles/condensed_vehicle.h"

namespace fourpost {

/// One oscillatory mode about static equilibrium, dashpots at their mean rates.
struct Mode {
  /// |pole| / 2 pi; the undamped frequency of the mode.
  double frequency_Hz = 0;
  double damping_ratio = 0;
  std::complex<double> pole;
  /// Motion of the independent coordinates, largest entry 1.
  Eigen::VectorXcd shape;
  /// In the field's terms: heave, pitch, roll, front hop, rear tramp ...
  std::string name;
};

/// State matrix of [s, s', extension of each series spring], dashpots at their mean rates.
Eigen::MatrixXd StateMatrix(const CondensedModel& model);

/// Oscillatory modes by rising frequency; a mode is named after the body and direction that carry most of its kinetic
/// energy.
std::vector<Mode> ModesOf(const CondensedVehicle& vehicle, std::span<const double> parameters);

}  // namespace fourpost
