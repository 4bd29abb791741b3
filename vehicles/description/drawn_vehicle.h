#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicles/description/vehicle.h"

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

}  // namespace fourpost
