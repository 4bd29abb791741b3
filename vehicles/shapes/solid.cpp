#include "vehicles/shapes/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "vehicles/shapes/findings.h"
#include "vehicles/shapes/shape_error.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

void RequireLength(double length) {
  if (!(length > 0)) throw ShapeError(kShapeLength);
}

/// A side of a triangle: the two vertices, and whether it is passed from the lower to the higher index.
struct Side {
  int low = 0;
  int high = 0;
  bool is_upward = false;
};

std::vector<Side> SortedSides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(static_cast<std::size_t>(mesh.triangles.size()));
  for (Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int from = mesh.triangles(i, t);
      const int to = mesh.triangles((i + 1) % 3, t);
      sides.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  return sides;
}

/// "the edge from (0 0 0) to (1 0 0)".
std::string EdgeText(const Mesh& mesh, const Side& side) {
  std::ostringstream text;
  const auto point = [&](int index) {
    const Vector3d v = mesh.vertices.col(index);
    text << "(" << v.x() << " " << v.y() << " " << v.z() << ")";
  };
  text << "the edge from ";
  point(side.low);
  text << " to ";
  point(side.high);
  return text.str();
}

/// What is wrong with the edge that `count` triangles share, beginning with `side`.
ShapeError EdgeFault(const Mesh& mesh, const Side& side, std::ptrdiff_t count) {
  const std::string edge = EdgeText(mesh, side);
  if (count == 1) return ShapeError(kSurfaceOpen, {edge});
  if (count == 2) return ShapeError(kSurfaceFlipped, {edge});
  return ShapeError(kSurfaceBranches, {std::to_string(count), edge});
}

/// Throws unless two triangles meet at each edge and pass it in opposite directions.
void RequireClosed(const Mesh& mesh) {
  const std::vector<Side> sides = SortedSides(mesh);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto next = std::find_if(
        side, sides.end(), [&](const Side& other) { return other.low != side->low || other.high != side->high; });
    if (next - side != 2 || side[0].is_upward == side[1].is_upward) throw EdgeFault(mesh, *side, next - side);
    side = next;
  }
}

/// Integrals of 1, r and r r' over what a surface encloses, and its area.
struct Moments {
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  double area = 0;

  void AddTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double v = a.dot(b.cross(c)) / 6;
    const Vector3d s = a + b + c;
    volume += v;
    first += v / 4 * s;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    area += (b - a).cross(c - a).norm() / 2;
  }
};

/// About `origin`.
Moments MomentsOf(const Mesh& mesh, const Vector3d& origin) {
  Moments moments;
  for (Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Vector3d { return mesh.vertices.col(mesh.triangles(i, t)) - origin; };
    moments.AddTriangle(corner(0), corner(1), corner(2));
  }
  return moments;
}

void RequireVolume(const Mesh& mesh, const Moments& moments) {
  // Files and their reader give vertices in single precision.
  const double rounding = std::numeric_limits<float>::epsilon() * mesh.vertices.cwiseAbs().maxCoeff() * moments.area;
  if (!(std::abs(moments.volume) > rounding)) throw ShapeError(kSurfaceFlat);
  if (moments.volume < 0) throw ShapeError(kSurfaceInward);
}

}  // namespace

Eigen::Matrix3d Solid::Inertia() const { return second_moment.trace() * Eigen::Matrix3d::Identity() - second_moment; }

Solid BoxSolid(const Vector3d& edges) {
  RequireLength(edges.minCoeff());
  const double volume = edges.prod();
  return {.volume = volume, .second_moment = (volume / 12 * edges.cwiseAbs2()).asDiagonal()};
}

Solid CylinderSolid(double radius, double length) {
  RequireLength(std::min(radius, length));
  const double volume = std::numbers::pi * radius * radius * length;
  const double across = radius * radius / 4;
  return {.volume = volume, .second_moment = volume * Vector3d(across, across, length * length / 12).asDiagonal()};
}

Solid SphereSolid(double radius) {
  RequireLength(radius);
  const double volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
  return {.volume = volume, .second_moment = volume * radius * radius / 5 * Eigen::Matrix3d::Identity()};
}

Solid MeshSolid(const Mesh& mesh) {
  if (mesh.triangles.cols() == 0) throw ShapeError(kSurfaceFlat);
  RequireClosed(mesh);
  // Near the surface, so that large parts do not cancel.
  const Vector3d origin = mesh.Bounds().center();
  const Moments moments = MomentsOf(mesh, origin);
  RequireVolume(mesh, moments);
  const Vector3d offset = moments.first / moments.volume;
  return {.volume = moments.volume,
          .com = origin + offset,
          .second_moment = moments.second - moments.volume * offset * offset.transpose()};
}

Solid Mapped(const Solid& solid, const Eigen::Affine3d& map) {
  const Eigen::Matrix3d a = map.linear();
  const double stretch = std::abs(a.determinant());
  if (!(stretch > 0)) throw ShapeError(kShapeScale);
  return {.volume = stretch * solid.volume,
          .com = map * solid.com,
          .second_moment = stretch * a * solid.second_moment * a.transpose()};
}

Solid operator+(const Solid& a, const Solid& b) {
  const double volume = a.volume + b.volume;
  const Vector3d distance = b.com - a.com;
  // Parallel axes.
  const double reduced = a.volume * b.volume / volume;
  return {.volume = volume,
          .com = a.com + b.volume / volume * distance,
          .second_moment = a.second_moment + b.second_moment + reduced * distance * distance.transpose()};
}

}  // namespace fourpost
