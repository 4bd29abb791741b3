#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Degrees of freedom of a vehicle.
struct Mobility {
  /// Coordinates of the tree.
  int joint_coordinates = 0;
  /// Equations of fp:rod, fp:ball, fp:weld, fp:hinge.
  int loop_equations = 0;
  /// Their rank.
  int independent_equations = 0;
  /// joint_coordinates - independent_equations.
  int dof = 0;
  /// Closures with redundant equations, each with their number: "fp:weld 'x' (3 of 6)". They do no harm as long as
  /// bodies are rigid and positions exact, but their forces are indeterminate.
  std::vector<std::string> redundant;
  /// Largest closure error in the design pose [m, rad].
  double loop_residual = 0;
};

/// Throws FaultyInput, naming the loops and the remedy, for a vehicle that its loop closures lock: the findings of
/// LoopLocks, and locks of higher order. For these the closures must follow to poses five millimetres or milliradians
/// away, both ways along each independent motion and along combinations of them. If they can, the equations have the
/// same rank.
Mobility MobilityOf(const Vehicle& vehicle);

}  // namespace fourpost
