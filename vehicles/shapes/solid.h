#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicles/shapes/mesh.h"

namespace fourpost {

/// Volume integrals of a homogeneous body; times a density they are its mass properties.
struct Solid {
  /// [m^3].
  double volume = 0;
  /// Centre of volume [m].
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// Integral of (r - com)(r - com)' over the volume [m^5].
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();

  /// Per unit density, about the centre: trace(S) 1 - S with S the second moment; products of inertia are negative
  /// integrals [m^5].
  Eigen::Matrix3d Inertia() const;
};

/// A box about the origin with edges of these lengths along the axes [m].
/// This and the next two throw ShapeError for a length that is not above zero.
Solid BoxSolid(const Eigen::Vector3d& edges);

/// A circular cylinder about the origin, its axle along z [m].
Solid CylinderSolid(double radius, double length);

/// A sphere about the origin [m].
Solid SphereSolid(double radius);

/// Volume integrals of a closed surface, summed over the tetrahedra between its triangles and a point (divergence
/// theorem). With a, b, c the corners as seen from that point, v = a . (b x c)/6 and s = a + b + c, a tetrahedron adds
///   v to the volume,   v s/4 to the first moment,   v (a a' + b b' + c c' + s s')/20 to the second moment
/// (F. Tonon, J. Math. Stat. 1 (2005) 8-11). A shell that faces inward is a cavity. Throws ShapeError, with the
/// place, if the surface does not pass each of its edges once in either direction; and if the volume is within the
/// rounding of its vertices, or the surface faces inward. Self-intersection is not detected.
Solid MeshSolid(const Mesh& mesh);

/// The solid after a map; mirrors keep the volume positive. With A the map's linear part, volume |det A|, second moment
/// |det A| A S A'. Throws ShapeError if the map is singular.
Solid Mapped(const Solid& solid, const Eigen::Affine3d& map);

/// Sum of both; a common volume counts twice.
Solid operator+(const Solid& a, const Solid& b);

}  // namespace fourpost
