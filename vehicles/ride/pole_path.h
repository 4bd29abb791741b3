#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// One pole followed while a parameter changes.
struct PolePath {
  /// Name of its mode at the file's value: "heave"; "heave, slow pole" and "heave, fast pole" for an overdamped one;
  /// "heave, conjugate pole" for one that is below the real axis there, and visible where it meets that axis; "creep"
  /// for the pole of a damper's mount.
  std::string mode;
  /// One per value [1/s], on or above the real axis; NaN where it is the conjugate of another.
  std::vector<std::complex<double>> pole;
};

/// Paths of the poles about static equilibrium in the design pose, dashpots at their mean rates.
struct PolePaths {
  /// Index in Vehicle::parameters.
  std::size_t parameter = 0;
  /// Of the parameter, SI.
  std::vector<double> values;
  /// By rising frequency at the first value.
  std::vector<PolePath> paths;
};

/// Poles at these values of one parameter, the others as in the file. Each is followed outward from the file's value,
/// which need not be among these, in small steps to the nearest pole with the most similar shape. Two poles that meet
/// on the real axis and part there are two paths. Rigid-body modes, at zero throughout, are left out. Throws
/// FaultyInput if the vehicle cannot be assembled or held, std::invalid_argument without a value.
PolePaths FollowPoles(const Vehicle& vehicle, std::size_t parameter, const std::vector<double>& values);

}  // namespace fourpost
