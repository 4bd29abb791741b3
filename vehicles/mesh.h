#pragma once

#include <filesystem>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fourpost {

/// A surface of triangles, in the unit of its file.
struct Mesh {
  Eigen::Matrix3Xd vertices;
  /// Columns of `vertices`, anticlockwise seen from outside.
  Eigen::Matrix3Xi triangles;

  Eigen::AlignedBox3d Bounds() const;
};

/// Reads a mesh file of any format that assimp knows, such as OBJ, STL or glTF. Equal vertices are joined; lines and
/// points are dropped. Throws std::runtime_error with the reason.
Mesh ReadMesh(const std::filesystem::path& file);

}  // namespace fourpost
