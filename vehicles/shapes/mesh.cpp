#include "vehicles/shapes/mesh.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOStream.hpp>
#include <assimp/Importer.hpp>

#include "analysis/files/text_file.h"
#include "vehicles/shapes/findings.h"
#include "vehicles/shapes/shape_error.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr std::size_t kMostTriangles = 2'000'000;
constexpr std::size_t kLargestFile_MiB = 64;

/// Whether following `file`, links too, leads into the folder or one below it.
bool IsWithin(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::filesystem::path whole = std::filesystem::weakly_canonical(file);
  return std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end()).first == folder.end();
}

/// Files on disk, the mesh's own and those beside it that it refers to, unless they are too large.
class SmallFiles : public Assimp::DefaultIOSystem {
 public:
  explicit SmallFiles(const std::filesystem::path& mesh)
      : mesh_(mesh.string()), folder_(std::filesystem::weakly_canonical(mesh.parent_path())) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    // A mesh that came from elsewhere must not carry other files of this machine into a report.
    if (file != mesh_ && !IsWithin(folder_, file)) throw ShapeError(kMeshElsewhere, {file});
    Assimp::IOStream* stream = DefaultIOSystem::Open(file, mode);
    if (!stream || stream->FileSize() <= kLargestFile_MiB << 20) return stream;
    Close(stream);
    throw ShapeError(kMeshFileTooLarge, {file, std::to_string(kLargestFile_MiB) + " MiB"});
  }

 private:
  std::string mesh_;
  std::filesystem::path folder_;
};

Eigen::Vector3d ToEigen(const aiVector3D& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Eigen::Affine3d ToEigen(const aiMatrix4x4& m) {
  Eigen::Matrix<ai_real, 3, 4> rows;
  rows << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
  Eigen::Affine3d map;
  map.affine() = rows.cast<double>();
  return map;
}

/// Throws for what must not meet code that trusts it.
void CheckPart(const aiMesh& part) {
  for (unsigned i = 0; i < part.mNumVertices; ++i)
    if (!ToEigen(part.mVertices[i]).allFinite()) throw ShapeError(kMeshVertex);
  for (unsigned i = 0; i < part.mNumFaces; ++i)
    for (unsigned corner = 0; corner < part.mFaces[i].mNumIndices; ++corner)
      if (part.mFaces[i].mIndices[corner] >= part.mNumVertices) throw ShapeError(kMeshIndex);
}

[[noreturn]] void RethrowFault(const Assimp::Importer& importer) {
  if (importer.GetException()) std::rethrow_exception(importer.GetException());
  throw ShapeError(kMeshUnreadable, {importer.GetErrorString()});
}

/// The file's scene, all polygons split into triangles.
const aiScene& ReadScene(const std::filesystem::path& file, Assimp::Importer& importer) {
  importer.SetIOHandler(new SmallFiles(std::filesystem::absolute(file)));  // the importer owns it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(std::filesystem::absolute(file).string(), 0);
  if (!scene) RethrowFault(importer);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) CheckPart(*scene->mMeshes[i]);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) throw ShapeError(kMeshNoScene);
  return *scene;
}

/// Collects triangles and joins their vertices where these are equal to the last digit.
class MeshBuilder {
 public:
  /// The parts of this node and of those below it.
  void Add(const aiScene& scene, const aiNode& node, const Eigen::Affine3d& above) {
    const Eigen::Affine3d pose = above * ToEigen(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) Add(*scene.mMeshes[node.mMeshes[i]], pose);
    for (unsigned i = 0; i < node.mNumChildren; ++i) Add(scene, *node.mChildren[i], pose);
  }

  Mesh Result() const {
    Mesh mesh{.vertices = Eigen::Matrix3Xd(3, Count(vertices_)), .triangles = Eigen::Matrix3Xi(3, Count(triangles_))};
    for (Index i = 0; i < mesh.vertices.cols(); ++i) mesh.vertices.col(i) = vertices_[static_cast<std::size_t>(i)];
    for (Index i = 0; i < mesh.triangles.cols(); ++i) mesh.triangles.col(i) = triangles_[static_cast<std::size_t>(i)];
    return mesh;
  }

 private:
  struct Hash {
    std::size_t operator()(const Eigen::Vector3d& v) const {
      std::size_t hash = 0;
      for (const double x : v) hash = 31 * hash + std::hash<double>()(x);
      return hash;
    }
  };

  template <typename T>
  static Index Count(const std::vector<T>& items) {
    return static_cast<Index>(items.size());
  }

  void Add(const aiMesh& part, const Eigen::Affine3d& pose) {
    const bool is_mirrored = pose.linear().determinant() < 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;
      Eigen::Vector3i triangle;
      for (int corner = 0; corner < 3; ++corner)
        triangle[corner] = Place(pose * ToEigen(part.mVertices[face.mIndices[corner]]));
      if (is_mirrored) std::swap(triangle[1], triangle[2]);
      Add(triangle);
    }
  }

  void Add(const Eigen::Vector3i& triangle) {
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) return;
    if (triangles_.size() == kMostTriangles) throw ShapeError(kMeshTriangles, {std::to_string(kMostTriangles)});
    triangles_.push_back(triangle);
  }

  int Place(const Eigen::Vector3d& vertex) {
    if (!vertex.allFinite()) throw ShapeError(kMeshVertex);
    const auto [place, is_new] = places_.try_emplace(vertex, static_cast<int>(vertices_.size()));
    if (is_new) vertices_.push_back(vertex);
    return place->second;
  }

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3i> triangles_;
  std::unordered_map<Eigen::Vector3d, int, Hash> places_;
};

void CheckFormat(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* known : {".obj", ".stl", ".dae", ".gltf", ".glb"})
    if (extension == known) return;
  throw ShapeError(kMeshFormat);
}

Mesh ReadAnyMesh(const std::filesystem::path& file) {
  CheckFormat(file);
  if (const Found reason = WhyNoFile(file)) throw ShapeError(kMeshNotAFile, reason.words);
  Assimp::Importer importer;
  const aiScene& scene = ReadScene(file, importer);
  MeshBuilder builder;
  builder.Add(scene, *scene.mRootNode, Eigen::Affine3d::Identity());
  Mesh mesh = builder.Result();
  if (mesh.triangles.cols() == 0) throw ShapeError(kMeshEmpty);
  return mesh;
}

}  // namespace

Eigen::AlignedBox3d Mesh::Bounds() const {
  Eigen::AlignedBox3d bounds;
  for (Index i = 0; i < vertices.cols(); ++i) bounds.extend(vertices.col(i));
  return bounds;
}

Mesh ReadMesh(const std::filesystem::path& file) {
  const std::string name = "mesh '" + file.string() + "'";
  try {
    return ReadAnyMesh(file);
  } catch (const ShapeError& error) {
    throw ShapeError(error.kind(), error.words(), name);
  } catch (const std::exception& error) {
    throw ShapeError(kMeshUnreadable, {error.what()}, name);
  }
}

}  // namespace fourpost
