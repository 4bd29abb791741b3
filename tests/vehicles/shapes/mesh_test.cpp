#include "vehicles/shapes/mesh.h"

#include <array>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"
#include "tests/vehicles/shapes/shape_refusal.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"
#include "vehicles/shapes/findings.h"
#include "vehicles/shapes/solid.h"

namespace fourpost::mesh_test {
namespace {

const std::filesystem::path kMeshes = std::filesystem::path(FOURPOST_SOURCE_DIR) / "meshes";
/// Holds one block of 1 x 2 x 4 with a corner at the origin, in each format.
const std::filesystem::path kBlocks = std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests" / "data" / "meshes";

using Corner = std::array<double, 3>;

/// The triangles by their corners, whatever the order in the file; each begins with its least corner.
std::multiset<std::array<Corner, 3>> Triangles(const Mesh& mesh) {
  std::multiset<std::array<Corner, 3>> triangles;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    std::array<Corner, 3> triangle;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d corner = mesh.vertices.col(mesh.triangles(i, t));
      triangle[static_cast<std::size_t>(i)] = {corner.x(), corner.y(), corner.z()};
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.insert(triangle);
  }
  return triangles;
}

TEST(Mesh, ReadsABox) {
  const Mesh box = ReadMesh(kMeshes / "box.stl");
  EXPECT_EQ(box.vertices.cols(), 8);
  EXPECT_EQ(box.triangles.cols(), 12);
  EXPECT_EQ(box.Bounds().min(), Eigen::Vector3d::Constant(-0.5));
  EXPECT_EQ(box.Bounds().max(), Eigen::Vector3d::Constant(0.5));
}

TEST(Mesh, IsTheSameInAllFormats) {
  const Mesh block = ReadMesh(kBlocks / "block.obj");
  EXPECT_EQ(block.Bounds().max(), Eigen::Vector3d(1, 2, 4));
  EXPECT_EQ(MeshSolid(block).volume, 8);
  for (const char* file : {"block_text.stl", "block_binary.stl", "block.dae", "block.gltf", "block.glb"}) {
    const Mesh other = ReadMesh(kBlocks / file);
    EXPECT_EQ(other.vertices.cols(), 8) << file;
    EXPECT_EQ(Triangles(other), Triangles(block)) << file;
    EXPECT_EQ(MeshSolid(other).volume, 8) << file;
  }
}

TEST(Mesh, OfTheProjectIsClosedAndOutward) {
  for (const auto& entry : std::filesystem::directory_iterator(kMeshes)) {
    if (entry.path().extension() != ".stl") continue;
    EXPECT_NO_THROW(MeshSolid(ReadMesh(entry.path()))) << entry.path();
  }
}

TEST(Mesh, WheelHasTheVolumeOfItsPrism) {
  // Area of a regular polygon of 32 corners on a circle of 0.385 m, times 0.2 m; the file has four decimals.
  const double area = 16 * 0.385 * 0.385 * std::sin(2 * std::numbers::pi / 32);
  EXPECT_NEAR(MeshSolid(ReadMesh(kMeshes / "wheel.stl")).volume, 0.2 * area, 2 * std::numbers::pi * 0.385 * 0.2 * 1e-4);
}

/// Meshes that are the block with one thing changed.
class ChangedBlock : public ::testing::Test {
 protected:
  static std::string Text(const std::string& file) { return ReadText(kBlocks / file); }

  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::filesystem::copy_file(kBlocks / "block.bin", folder_.path() / "block.bin",
                               std::filesystem::copy_options::overwrite_existing);
    return folder_.Write(name, text);
  }

  /// The file must be refused with its name and this reason.
  void ExpectRefused(const std::string& name, const std::string& text, const Finding& kind,
                     const std::string& word = "") const {
    const std::filesystem::path file = Write(name, text);
    EXPECT_THAT([&] { ReadMesh(file); }, RefusesShape(kind, {name, word}));
  }

  TemporaryFolder folder_;
};

TEST_F(ChangedBlock, MayHaveCapitalsInItsExtension) {
  EXPECT_EQ(ReadMesh(Write("block.OBJ", Text("block.obj"))).triangles.cols(), 12);
}

TEST_F(ChangedBlock, MayHaveQuadrangles) {
  const std::string text = Replace(Text("block.obj"), "f 1 3 4\nf 1 4 2\n", "f 1 3 4 2\n");
  const Mesh mesh = ReadMesh(Write("quadrangles.obj", text));
  EXPECT_EQ(mesh.triangles.cols(), 12);
  EXPECT_EQ(MeshSolid(mesh).volume, 8);
}

TEST_F(ChangedBlock, StaysClosedInParts) {
  const std::string text = Replace(Text("block.obj"), "f 3 7 8\n", "o lid\nusemtl red\nf 3 7 8\n");
  const Mesh mesh = ReadMesh(Write("parts.obj", text));
  EXPECT_EQ(mesh.vertices.cols(), 8);
  EXPECT_EQ(MeshSolid(mesh).volume, 8);
}

TEST_F(ChangedBlock, LosesTrianglesWithoutArea) {
  const std::string sliver = "v 1 2 4\nf 8 9 6\n";
  EXPECT_EQ(ReadMesh(Write("sliver.obj", Text("block.obj") + sliver)).triangles.cols(), 12);
}

TEST_F(ChangedBlock, KeepsTheAxesOfADaeFile) {
  const Mesh turned = ReadMesh(Write("turned.dae", Replace(Text("block.dae"), "Z_UP", "Y_UP")));
  EXPECT_EQ(turned.Bounds().max(), Eigen::Vector3d(1, 2, 4));
}

TEST_F(ChangedBlock, IsInMetresWhenADaeFileSaysSo) {
  const Mesh small = ReadMesh(Write("small.dae", Replace(Text("block.dae"), R"(meter="1")", R"(meter="0.001")")));
  // Single precision.
  EXPECT_NEAR(small.Bounds().max().z(), 0.004, 0.004 * std::numeric_limits<float>::epsilon());
}

TEST_F(ChangedBlock, StandsWhereItsNodePutsItAndStaysOutward) {
  const Mesh mirrored =
      ReadMesh(Write("mirrored.gltf", Replace(Text("block.gltf"), R"({"mesh": 0})",
                                              R"({"mesh": 0, "scale": [-1, 1, 1], "translation": [10, 0, 0]})")));
  EXPECT_EQ(mirrored.Bounds().min(), Eigen::Vector3d(9, 0, 0));
  EXPECT_EQ(mirrored.Bounds().max(), Eigen::Vector3d(10, 2, 4));
  EXPECT_EQ(MeshSolid(mirrored).volume, 8);
}

TEST_F(ChangedBlock, IsRefusedInAnotherFormat) {
  ExpectRefused("block.ply", "ply\n", kMeshFormat, ".obj");
  ExpectRefused("block", Text("block.obj"), kMeshFormat);
}

TEST_F(ChangedBlock, IsRefusedWithIndicesOutOfRange) {
  ExpectRefused("index.obj", Replace(Text("block.obj"), "f 2 8 6", "f 2 9 6"), kMeshUnreadable, "index out of range");
  ExpectRefused("index.dae", Replace(Text("block.dae"), "1 7 5<", "1 8 5<"), kMeshUnreadable,
                "Invalid data index (8/8)");
}

TEST_F(ChangedBlock, IsRefusedWithVerticesThatAreNotFinite) {
  ExpectRefused("nan.obj", Replace(Text("block.obj"), "v 1 2 4", "v nan 2 4"), kMeshVertex);
  ExpectRefused("large.obj", Replace(Text("block.obj"), "v 1 2 4", "v 1e39 2 4"), kMeshVertex);
}

TEST_F(ChangedBlock, IsRefusedWithoutItsBuffer) {
  ExpectRefused("buffer.gltf", Replace(Text("block.gltf"), "block.bin", "none.bin"), kMeshUnreadable, "none.bin");
}

TEST_F(ChangedBlock, IsRefusedWithABufferOutsideItsFolder) {
  std::filesystem::create_directory(folder_.path() / "car");
  std::filesystem::create_symlink("../block.bin", folder_.path() / "car/link.bin");
  for (const char* buffer : {"../block.bin", "link.bin"}) {
    const std::filesystem::path mesh = Write("car/block.gltf", Replace(Text("block.gltf"), "block.bin", buffer));
    EXPECT_THAT([&] { ReadMesh(mesh); }, RefusesShape(kMeshElsewhere));
  }
  std::filesystem::create_directory(folder_.path() / "parts");
  std::filesystem::copy_file(kBlocks / "block.bin", folder_.path() / "parts/block.bin");
  EXPECT_EQ(ReadMesh(Write("below.gltf", Replace(Text("block.gltf"), "block.bin", "parts/block.bin"))).triangles.cols(),
            12);
}

TEST_F(ChangedBlock, IsRefusedCutShort) {
  ExpectRefused("short.stl", Text("block_binary.stl").substr(0, 600), kMeshUnreadable);
}

TEST_F(ChangedBlock, IsRefusedWithoutTriangles) {
  ExpectRefused("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 3\n", kMeshEmpty);
}

TEST_F(ChangedBlock, IsRefusedAboveTheLimitOfFiles) {
  const std::filesystem::path large = folder_.Write("large.obj", "");
  std::filesystem::resize_file(large, (64ULL << 20) + 1);  // no blocks on disk
  const auto is_refused = RefusesShape(kMeshFileTooLarge, {"large.obj", "64 MiB"});
  EXPECT_THAT([&] { ReadMesh(large); }, is_refused);
  const std::filesystem::path by_buffer = Write("block.gltf", Replace(Text("block.gltf"), "block.bin", "large.obj"));
  EXPECT_THAT([&] { ReadMesh(by_buffer); }, is_refused);
}

TEST_F(ChangedBlock, IsRefusedAboveTheLimitOfTriangles) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 2'000'000; ++i) text += "f 1 2 3\n";
  EXPECT_EQ(ReadMesh(Write("many.obj", text)).triangles.cols(), 2'000'000);
  ExpectRefused("more.obj", text + "f 1 2 3\n", kMeshTriangles, "2000000");
}

class MeshFile : public VehicleFileTest {
 protected:
  /// The small vehicle with this mesh on its body, in line 16.
  static std::string WithMesh(const std::string& attributes) {
    return Replaced(kSmallVehicle, R"(<box size="1 2 3"/>)", "<mesh " + attributes + "/>");
  }
};

TEST_F(MeshFile, IsFoundBesideTheVehicleFile) {
  Write(ReadText(kMeshes / "box.stl"), "cube.stl");
  const std::optional<Vehicle> vehicle = Read(WithMesh(R"(filename="./cube.stl" scale="0.001 0.002 0.003")"));
  ASSERT_TRUE(vehicle.has_value());
  const Visual& visual = vehicle->links.at(2).visuals.at(0);
  EXPECT_EQ(visual.shape, Visual::Shape::kMesh);
  EXPECT_EQ(visual.mesh_file, folder_ / "cube.stl");
  EXPECT_EQ(visual.size, Eigen::Vector3d(0.001, 0.002, 0.003));
}

// The folder of a fit may be moved away from the meshes.
TEST_F(MeshFile, MayBeMissing) {
  EXPECT_TRUE(Read(WithMesh(R"(filename="none.obj" scale="1 1 1")")).has_value());
  Expect(16, kMeshMissing, {"mesh 'none.obj'"});
}

TEST_F(MeshFile, MustBeReadable) {
  Write("no mesh", "text.obj");
  EXPECT_FALSE(Read(WithMesh(R"(filename="text.obj" scale="1 1 1")")).has_value());
  Expect(16, kMeshUnreadable, {"mesh 'text.obj'"});
}

TEST_F(MeshFile, NeedsAScale) {
  Write(ReadText(kMeshes / "box.stl"), "cube.stl");
  EXPECT_FALSE(Read(WithMesh(R"(filename="cube.stl")")).has_value());
  Expect(16, kAttributeMissing, {"'scale'"});
}

TEST_F(MeshFile, MustNotBeAPackageAddress) {
  EXPECT_FALSE(Read(WithMesh(R"(filename="package://fourpost/box.stl" scale="1 1 1")")).has_value());
  Expect(16, kMeshAddress, {"package://fourpost/box.stl"});
}

TEST(Mesh, SaysWhyItCannotBeRead) {
  EXPECT_THAT([] { ReadMesh("/nowhere/none.obj"); }, RefusesShape(kMeshUnreadable, {"none.obj"}));
}

}  // namespace
}  // namespace fourpost::mesh_test
