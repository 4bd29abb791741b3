#pragma once

#include <filesystem>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fourpost {

/// A surface of triangles, in the axes and the unit of its file.
struct Mesh {
  /// No two are equal.
  Eigen::Matrix3Xd vertices;
  /// Columns of `vertices`, three different ones each, anticlockwise seen from outside.
  Eigen::Matrix3Xi triangles;

  Eigen::AlignedBox3d Bounds() const;
};

/// Reads an OBJ, STL, DAE (Collada) or glTF file (.gltf, .glb), recognised by its extension, in single precision. Equal
/// vertices are joined, also across parts; polygons are split into triangles; triangles with two equal corners, lines
/// and points are dropped. The nodes of DAE and glTF position their parts. The unit in a DAE file converts its numbers
/// to metres; axes are never turned. Throws ShapeError for what cannot be read, also for a file above 64 MiB (that one
/// or another that it needs), more than 2 million triangles, indices out of range and vertices that are not finite.
Mesh ReadMesh(const std::filesystem::path& file);

}  // namespace fourpost
