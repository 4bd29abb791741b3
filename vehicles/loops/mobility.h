#pragma once

#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How freely a vehicle moves.
struct Mobility {
  /// Of the tree.
  int joint_coordinates = 0;
  /// Of fp:rod, fp:ball, fp:weld, fp:hinge.
  int loop_equations = 0;
  /// Their rank.
  int independent_equations = 0;
  /// joint_coordinates - independent_equations.
  int dof = 0;
  /// Closures of which equations follow from those of the others, each with how many: "fp:weld 'x' (3 of 6)". They do
  /// no harm as long as bodies are rigid and positions exact, but leave the forces in them open.
  std::vector<std::string> redundant;
  /// Largest closure error in the design pose [m, rad].
  double loop_residual = 0;
};

/// Throws FaultyInput, naming the loops and what to do, for a vehicle that its loop closures lock: what LoopLocks
/// finds, and locks of higher order, where the closures cannot follow to poses five millimetres or milliradians away,
/// each way along each independent motion and along combinations of them. Where they can, the equations have the same
/// rank.
Mobility MobilityOf(const Vehicle& vehicle);

}  // namespace fourpost
