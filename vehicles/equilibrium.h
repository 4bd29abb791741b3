#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/diagnostics.h"
#include "vehicles/vehicle.h"

namespace fourpost {

/// A force of the design pose that equilibrium does not set: the weight of a link, or a preload that the file gives.
struct GivenForce {
  enum class Kind { kWeight, kPreload };
  Kind kind = Kind::kWeight;
  /// As messages call it: "link 'body'", "fp:spring 'coil'".
  std::string element;
  int line = 0;
  /// At the file's parameter values [kg or N]; 0 for what only a parameter can bring about.
  double size = 0;
  /// Indices of the parameters that it follows.
  std::vector<int> parameters;
  /// Generalised force per unit of `size`.
  Eigen::VectorXd direction;
};

/// The least preloads that hold a generalised force w are PreloadMap(holders) w: where a car is statically
/// indeterminate its sides share alike. `holders`: generalised force per unit of each preload that equilibrium sets, in
/// columns; there may be none.
Eigen::MatrixXd PreloadMap(const Eigen::MatrixXd& holders);

/// Static equilibrium in the design pose, sum of given forces + holders times preloads = 0, must have a solution at the
/// file's parameter values and wherever parameters with bounds go. Adds an error for each element that stands against
/// it.
void CheckEquilibrium(const Vehicle& vehicle, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders,
                      Diagnostics& faults);

}  // namespace fourpost
