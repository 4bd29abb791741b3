#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// A damper whose dry friction holds throughout a stepped sine, so that the damper passes motion on like a rod, or like
/// its mount alone.
struct LockedFriction {
  /// Index in Vehicle::dampers.
  std::size_t damper = 0;
  double friction_N = 0;
  /// About so many times the motion makes it slide, soonest at this frequency; 0 of a history. As a held damper answers
  /// in proportion.
  double factor = 0;
  double frequency_Hz = 0;
};

/// Dampers with dry friction at the file's values: indices in Vehicle::dampers.
std::vector<std::size_t> RubbingDampers(const Vehicle& vehicle);

/// A strut sensor, which reads the extension, on each of these dampers.
std::vector<Sensor> ExtensionSensors(const Vehicle& vehicle, const std::vector<std::size_t>& dampers);

/// Dampers that never slide: friction F tanh(v / v_f) of a damper without mount holds while its extension rate stays
/// below v_f, that of one with a mount of stiffness k while the mount's force k e stays below F; e, v: first harmonics
/// of the linearised balance. Dampers that the motion does not work, by symmetry, are left out.
/// Throws as CondensedVehicle and SolveHarmonicBalance do.
std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Excitation& excitation);

/// The same of a history: e its extensions from rest, samples x dampers [m], and v their differences. Of the dampers of
/// RubbingDampers.
std::vector<LockedFriction> FindLockedFriction(const Vehicle& vehicle, const Eigen::MatrixXd& extensions,
                                               double rate_Hz);

}  // namespace fourpost
