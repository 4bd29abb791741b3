#include "vehicles/mesh.h"

#include <stdexcept>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

namespace fourpost {
namespace {

using Eigen::Index;

/// Appends a part of the scene.
void Append(const aiMesh& part, Mesh& mesh) {
  const Index first_vertex = mesh.vertices.cols();
  const Index first_triangle = mesh.triangles.cols();
  mesh.vertices.conservativeResize(Eigen::NoChange, first_vertex + part.mNumVertices);
  mesh.triangles.conservativeResize(Eigen::NoChange, first_triangle + part.mNumFaces);
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& vertex = part.mVertices[i];
    mesh.vertices.col(first_vertex + i) << static_cast<double>(vertex.x), static_cast<double>(vertex.y),
        static_cast<double>(vertex.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i)
    for (unsigned corner = 0; corner < 3; ++corner)
      mesh.triangles(corner, first_triangle + i) =
          static_cast<int>(first_vertex) + static_cast<int>(part.mFaces[i].mIndices[corner]);
}

}  // namespace

Eigen::AlignedBox3d Mesh::Bounds() const {
  Eigen::AlignedBox3d bounds;
  for (Index i = 0; i < vertices.cols(); ++i) bounds.extend(vertices.col(i));
  return bounds;
}

Mesh ReadMesh(const std::filesystem::path& file) {
  Assimp::Importer importer;
  // Vertices differ in position only, so that joining finds all equal ones.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                          aiComponent_COLORS | aiComponent_TEXCOORDS);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_RemoveComponent | aiProcess_Triangulate |
                                                              aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                                              aiProcess_PreTransformVertices);
  if (!scene) throw std::runtime_error("mesh '" + file.string() + "' cannot be read: " + importer.GetErrorString());
  Mesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) Append(*scene->mMeshes[i], mesh);
  if (mesh.triangles.cols() == 0) throw std::runtime_error("mesh '" + file.string() + "' has no triangles");
  return mesh;
}

}  // namespace fourpost
