#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// A damper whose dry friction sticks throughout a stepped sine, so that the damper acts like a rod, or like its mount
/// alone.
struct LockedFriction {
  /// Index in Vehicle::dampers.
  std::size_t damper = 0;
  double friction_N = 0;
  /// Approximate factor on the motion at which it begins to slide, at this frequency; 0 for a history. Assumes
  /// proportional response of the locked damper.
  double factor = 0;
  double frequency_Hz = 0;
};

/// Dampers with dry friction at the file's values: indices in Vehicle::dampers.
std::vector<std::size_t> RubbingDampers(const Vehicle& vehicle);

/// A strut sensor, which reads the extension, on each of these dampers.
std::vector<Sensor> ExtensionSensors(const Vehicle& vehicle, const std::vector<std::size_t>& dampers);

/// Dampers that never slide: friction F tanh(v / v_f) of a damper without mount sticks while its extension rate stays
/// below v_f, that of one with a mount of stiffness k, or of its own, while k e stays below F; e, v: first harmonics
/// of the linearised harmonic balance. Dampers that do not move, by symmetry, are left out. Throws as CondensedVehicle
/// and SolveHarmonicBalance do.
std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Excitation& excitation);

/// The same for a history: e its extensions from rest, samples x dampers [m], and v their differences. For the dampers
/// of RubbingDampers.
std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Eigen::MatrixXd& extensions,
                                               double rate_Hz);

}  // namespace fourpost
