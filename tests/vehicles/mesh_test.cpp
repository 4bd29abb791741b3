#include "vehicles/mesh.h"

#include <map>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"
#include "tests/vehicles/small_vehicle.h"

namespace fourpost {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kMeshes = std::filesystem::path(FOURPOST_SOURCE_DIR) / "meshes";

/// Each edge is passed once in either direction: closed, and of one orientation.
bool IsClosed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> count;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.triangles(i, t);
      const int b = mesh.triangles((i + 1) % 3, t);
      count[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::all_of(count.begin(), count.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Divergence theorem; positive when triangles face outward.
double Volume(const Mesh& mesh) {
  double volume = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Eigen::Vector3d { return mesh.vertices.col(mesh.triangles(i, t)); };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return volume;
}

TEST(Mesh, ReadsABox) {
  const Mesh box = ReadMesh(kMeshes / "box.obj");
  EXPECT_EQ(box.vertices.cols(), 8);
  EXPECT_EQ(box.triangles.cols(), 12);
  EXPECT_EQ(box.Bounds().min(), Eigen::Vector3d::Constant(-0.5));
  EXPECT_EQ(box.Bounds().max(), Eigen::Vector3d::Constant(0.5));
  EXPECT_EQ(Volume(box), 1);
}

TEST(Mesh, OfTheProjectIsClosedAndOutward) {
  for (const auto& entry : std::filesystem::directory_iterator(kMeshes)) {
    if (entry.path().extension() != ".obj") continue;
    const Mesh mesh = ReadMesh(entry.path());
    EXPECT_TRUE(IsClosed(mesh)) << entry.path();
    EXPECT_GT(Volume(mesh), 0) << entry.path();
  }
}

TEST(Mesh, WheelHasTheVolumeOfItsPrism) {
  // Area of a regular polygon of 32 corners on a circle of 0.385 m, times 0.2 m; the file has four decimals.
  const double area = 16 * 0.385 * 0.385 * std::sin(2 * std::numbers::pi / 32);
  EXPECT_NEAR(Volume(ReadMesh(kMeshes / "wheel.obj")), 0.2 * area, 2 * std::numbers::pi * 0.385 * 0.2 * 1e-4);
}

class MeshFile : public VehicleFileTest {
 protected:
  /// The small vehicle with this mesh on its body, in line 16.
  static std::string WithMesh(const std::string& attributes) {
    return Replaced(kSmallVehicle, R"(<box size="1 2 3"/>)", "<mesh " + attributes + "/>");
  }
};

TEST_F(MeshFile, IsFoundBesideTheVehicleFile) {
  Write(ReadText(kMeshes / "box.obj"), "cube.obj");
  const std::optional<Vehicle> vehicle = Read(WithMesh(R"(filename="./cube.obj" scale="0.001 0.002 0.003")"));
  ASSERT_TRUE(vehicle.has_value());
  const Visual& visual = vehicle->links.at(2).visuals.at(0);
  EXPECT_EQ(visual.shape, Visual::Shape::kMesh);
  EXPECT_EQ(visual.mesh_file, folder_ / "cube.obj");
  EXPECT_EQ(visual.size, Eigen::Vector3d(0.001, 0.002, 0.003));
}

TEST_F(MeshFile, MustExist) {
  EXPECT_FALSE(Read(WithMesh(R"(filename="none.obj" scale="1 1 1")")).has_value());
  Expect(Severity::kError, 16, "mesh 'none.obj' is missing");
}

TEST_F(MeshFile, MustBeReadable) {
  Write("no mesh", "text.obj");
  EXPECT_FALSE(Read(WithMesh(R"(filename="text.obj" scale="1 1 1")")).has_value());
  Expect(Severity::kError, 16, "mesh 'text.obj' is of no use");
}

TEST_F(MeshFile, NeedsAScale) {
  Write(ReadText(kMeshes / "box.obj"), "cube.obj");
  EXPECT_FALSE(Read(WithMesh(R"(filename="cube.obj")")).has_value());
  Expect(Severity::kError, 16, "needs the attribute 'scale'");
}

TEST_F(MeshFile, MustNotBeAPackageAddress) {
  EXPECT_FALSE(Read(WithMesh(R"(filename="package://fourpost/box.obj" scale="1 1 1")")).has_value());
  Expect(Severity::kError, 16, "package:// are not supported");
}

TEST(Mesh, SaysWhyItCannotBeRead) {
  try {
    ReadMesh("/nowhere/none.obj");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("none.obj"));
  }
}

}  // namespace
}  // namespace fourpost
