#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// One pole followed while a parameter changes.
struct PolePath {
  /// Of the mode that it belongs to at the file's value: "heave"; "heave, slow pole" and "heave, fast pole" of an
  /// overdamped one; "heave, conjugate pole" of one that is below the real axis there, and shows where it meets that
  /// axis; "creep" for one of a damper's mount.
  std::string mode;
  /// One per value [1/s], on or above the real axis; NaN where it is the conjugate of another.
  std::vector<std::complex<double>> pole;
};

/// What becomes of the poles about static equilibrium in the design pose, dashpots at their mean rates.
struct PolePaths {
  /// Index in Vehicle::parameters.
  std::size_t parameter = 0;
  /// Of the parameter, SI.
  std::vector<double> values;
  /// By rising frequency at the first value.
  std::vector<PolePath> paths;
};

/// Poles at these values of one parameter, the others as the file gives them, each followed from the file's value,
/// which need not be among these, outward: in small steps, to the pole that is nearest and whose shape is most alike.
/// Two that meet on the real axis and part there are two paths. Motions that nothing holds, at zero throughout, are
/// left out. Throws FaultyInput when the vehicle cannot be assembled or held, std::invalid_argument without a value.
PolePaths FollowPoles(const Vehicle& vehicle, std::size_t parameter, const std::vector<double>& values);

}  // namespace fourpost
