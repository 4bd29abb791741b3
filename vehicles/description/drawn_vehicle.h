#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// A vehicle as written, before its loops are closed, at its file's values.
struct DrawnVehicle {
  /// The vehicle must outlive this object.
  explicit DrawnVehicle(const Vehicle& described);

  double At(const Scalar& scalar) const { return scalar.At(values); }
  /// In ground axes.
  Eigen::Vector3d Place(const Point& point) const;
  /// Distance of the line's ends [m].
  double Length(const ForceLine& line) const;

  const Vehicle& vehicle;
  std::vector<double> values;
  std::vector<Eigen::Isometry3d> poses;
};

/// A plausibility check that needs only the description, so that it also works on a vehicle that cannot be assembled or
/// held: adds a warning, with a remedy, for each finding.
using DrawnLintRule = void (*)(const DrawnVehicle& drawn, FileFaults& findings);

}  // namespace fourpost
