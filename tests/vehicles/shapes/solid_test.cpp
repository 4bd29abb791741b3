#include "vehicles/shapes/solid.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "tests/rounding.h"
#include "tests/vehicles/shapes/shape_refusal.h"
#include "vehicles/shapes/findings.h"

namespace fourpost::solid_test {
namespace {

using std::numbers::pi;

Mesh MakeMesh(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  Mesh mesh{.vertices = Eigen::Matrix3Xd(3, vertices.size()), .triangles = Eigen::Matrix3Xi(3, triangles.size())};
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
  for (std::size_t i = 0; i < triangles.size(); ++i) mesh.triangles.col(static_cast<Eigen::Index>(i)) = triangles[i];
  return mesh;
}

/// A block of 1 x 2 x 4 with a corner at the origin.
Mesh Block() {
  std::vector<Eigen::Vector3d> vertices;
  for (const double z : {0, 4})
    for (const double y : {0, 2})
      for (const double x : {0, 1}) vertices.emplace_back(x, y, z);
  return MakeMesh(vertices, {{0, 2, 3},
                             {0, 3, 1},
                             {4, 5, 7},
                             {4, 7, 6},
                             {0, 1, 5},
                             {0, 5, 4},
                             {2, 6, 7},
                             {2, 7, 3},
                             {0, 4, 6},
                             {0, 6, 2},
                             {1, 3, 7},
                             {1, 7, 5}});
}

/// Corners such that the volume is positive.
Mesh Tetrahedron(std::vector<Eigen::Vector3d> corners) {
  if ((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) < 0)
    std::swap(corners[2], corners[3]);
  return MakeMesh(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// Two rings of `n` corners on a circle of radius 1 at z = -1 and 1 about the z axis, and the centres of the ends.
Mesh Prism(int n) {
  std::vector<Eigen::Vector3d> vertices = {{0, 0, -1}, {0, 0, 1}};
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    for (const double z : {-1, 1}) vertices.emplace_back(std::cos(angle), std::sin(angle), z);
    const int low = 2 + 2 * i;
    const int next = 2 + 2 * ((i + 1) % n);
    for (const Eigen::Vector3i& t : std::vector<Eigen::Vector3i>{
             {0, next, low}, {1, low + 1, next + 1}, {low, next, next + 1}, {low, next + 1, low + 1}})
      triangles.push_back(t);
  }
  return MakeMesh(vertices, triangles);
}

/// A unit sphere of n bands and 2n sectors.
Mesh Globe(int n) {
  std::vector<Eigen::Vector3d> vertices = {Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ()};
  std::vector<Eigen::Vector3i> triangles;
  const auto index = [&](int band, int sector) {
    return band == 0 ? 0 : band == n ? 1 : 2 + (band - 1) * 2 * n + sector % (2 * n);
  };
  for (int band = 0; band < n; ++band)
    for (int sector = 0; sector < 2 * n; ++sector) {
      const double tilt = pi * band / n;
      const double turn = pi * sector / n;
      if (band > 0)
        vertices.emplace_back(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
      if (band < n - 1)
        triangles.emplace_back(index(band, sector), index(band + 1, sector), index(band + 1, sector + 1));
      if (band > 0) triangles.emplace_back(index(band, sector), index(band + 1, sector + 1), index(band, sector + 1));
    }
  return MakeMesh(vertices, triangles);
}

Mesh Moved(Mesh mesh, const Eigen::Affine3d& map) {
  mesh.vertices = map * mesh.vertices;
  if (map.linear().determinant() < 0) mesh.triangles.row(1).swap(mesh.triangles.row(2));
  return mesh;
}

/// `tolerance` is relative to the largest number of each kind.
void ExpectEqual(const Solid& solid, const Solid& expected, double tolerance) {
  EXPECT_NEAR(solid.volume, expected.volume, tolerance * expected.volume);
  EXPECT_LE((solid.com - expected.com).cwiseAbs().maxCoeff(), tolerance * expected.com.cwiseAbs().maxCoeff());
  EXPECT_LE((solid.second_moment - expected.second_moment).cwiseAbs().maxCoeff(),
            tolerance * expected.second_moment.cwiseAbs().maxCoeff());
}

TEST(Solid, OfABoxHasItsInertia) {
  const Solid box = BoxSolid({1, 2, 4});
  EXPECT_EQ(box.volume, 8);
  EXPECT_EQ(box.com, Eigen::Vector3d::Zero());
  // m/12 (b^2 + c^2).
  const Eigen::Matrix3d expected = (8.0 / 12 * Eigen::Vector3d(4 + 16, 1 + 16, 1 + 4)).asDiagonal();
  EXPECT_LE((box.Inertia() - expected).cwiseAbs().maxCoeff(), 2 * kUlp * 40 / 3);
}

TEST(Solid, OfACylinderHasItsInertia) {
  const double mass = pi * 0.25 * 3;
  const Solid cylinder = CylinderSolid(0.5, 3);
  EXPECT_DOUBLE_EQ(cylinder.volume, mass);
  EXPECT_DOUBLE_EQ(cylinder.Inertia()(0, 0), mass * (3 * 0.25 + 9) / 12);
  EXPECT_DOUBLE_EQ(cylinder.Inertia()(2, 2), mass * 0.25 / 2);
  EXPECT_EQ(cylinder.Inertia()(0, 1), 0);
}

TEST(Solid, OfASphereHasItsInertia) {
  const double mass = 4 * pi / 3 * 8;
  const Solid sphere = SphereSolid(2);
  EXPECT_DOUBLE_EQ(sphere.volume, mass);
  EXPECT_DOUBLE_EQ(sphere.Inertia()(1, 1), 0.4 * mass * 4);
}

TEST(Solid, NeedsLengths) {
  EXPECT_THAT([] { BoxSolid({1, 2, 0}); }, RefusesShape(kShapeLength));
  EXPECT_THAT([] { BoxSolid({1, -2, -3}); }, RefusesShape(kShapeLength));
  EXPECT_THAT([] { CylinderSolid(1, 0); }, RefusesShape(kShapeLength));
  EXPECT_THAT([] { SphereSolid(kNan); }, RefusesShape(kShapeLength));
}

TEST(Solid, OfABoxMeshIsThatOfTheBox) {
  const Solid box = Mapped(BoxSolid({1, 2, 4}), Eigen::Affine3d(Eigen::Translation3d(0.5, 1, 2)));
  // Sums of twelve terms.
  ExpectEqual(MeshSolid(Block()), box, 12 * kUlp);
}

// Tetrahedron with corners p about their mean c: V/20 times the sum of (p - c)(p - c)'.
TEST(Solid, OfATetrahedronHasItsClosedForm) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(side(random), side(random), side(random)); };
  for (int i = 0; i < 100; ++i) {
    const Eigen::Affine3d map =
        Eigen::Translation3d(10 * vector()) * Eigen::AngleAxisd(pi * side(random), vector().normalized());
    const Mesh mesh = Moved(Tetrahedron({vector(), vector(), vector(), vector()}), map);
    const Eigen::Vector3d mean = mesh.vertices.rowwise().mean();
    const Eigen::Matrix3Xd arms = mesh.vertices.colwise() - mean;
    const Eigen::Matrix3d edges = arms.rightCols<3>().colwise() - arms.col(0);
    const Solid solid = MeshSolid(mesh);
    // Rounding of coordinates of 10 in a body of 1, and of the products of its lengths.
    constexpr double kTolerance = 100 * kUlp;
    EXPECT_NEAR(solid.volume, edges.determinant() / 6, kTolerance);
    // Thin ones divide by their volume.
    EXPECT_LE((solid.com - mean).cwiseAbs().maxCoeff(), kTolerance / solid.volume);
    EXPECT_LE((solid.second_moment - solid.volume / 20 * arms * arms.transpose()).cwiseAbs().maxCoeff(), kTolerance);
  }
}

// A regular polygon of n corners has sin(x)/x of the circle's area and sin(x)(2 + cos(x))/(3x) of its polar second
// moment, x = 2 pi/n: 1 - x^2/6 and 1 - x^2/3, to x^4.
TEST(Solid, OfAPrismTendsToTheCylinder) {
  const Solid cylinder = CylinderSolid(1, 2);
  for (const int n : {32, 320}) {
    const double x = 2 * pi / n;
    const Solid prism = MeshSolid(Prism(n));
    EXPECT_NEAR(prism.volume / cylinder.volume, std::sin(x) / x, n * kUlp);
    EXPECT_NEAR(prism.volume / cylinder.volume, 1 - x * x / 6, std::pow(x, 4));
    EXPECT_NEAR(prism.Inertia()(2, 2) / cylinder.Inertia()(2, 2), std::sin(x) * (2 + std::cos(x)) / (3 * x), n * kUlp);
    EXPECT_NEAR(prism.Inertia()(2, 2) / cylinder.Inertia()(2, 2), 1 - x * x / 3, std::pow(x, 4));
    EXPECT_LE(prism.com.cwiseAbs().maxCoeff(), n * kUlp);
  }
}

// Chords miss a sphere by the square of their length: half the length, a quarter of the error.
TEST(Solid, OfAGlobeTendsToTheSphere) {
  const Solid sphere = SphereSolid(1);
  const Solid coarse = MeshSolid(Globe(20));
  const Solid fine = MeshSolid(Globe(40));
  // Of the next order: (pi/20)^2.
  constexpr double kNextOrder = 0.025;
  EXPECT_NEAR((sphere.volume - coarse.volume) / (sphere.volume - fine.volume), 4, 4 * kNextOrder);
  for (int i = 0; i < 3; ++i) {
    const auto miss = [&](const Solid& solid) { return sphere.Inertia()(i, i) - solid.Inertia()(i, i); };
    EXPECT_NEAR(miss(coarse) / miss(fine), 4, 4 * kNextOrder);
    EXPECT_LT(miss(fine) / sphere.Inertia()(i, i), std::pow(pi / 40, 2));
  }
}

TEST(Solid, MovesAsItsMeshDoes) {
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  for (const Eigen::Vector3d& scale : {Eigen::Vector3d(2, 3, 0.5), Eigen::Vector3d(-2, 3, 0.5)}) {
    const Eigen::Affine3d map = Eigen::Translation3d(1, -2, 3) * turn * Eigen::Scaling(scale);
    // Some dozen operations on numbers of the mesh's size.
    ExpectEqual(Mapped(MeshSolid(Block()), map), MeshSolid(Moved(Block(), map)), 50 * kUlp);
  }
}

TEST(Solid, CannotBeFlattened) {
  EXPECT_THAT([] { Mapped(SphereSolid(1), Eigen::Affine3d(Eigen::Scaling(1.0, 0.0, 1.0))); },
              RefusesShape(kShapeScale));
}

TEST(Solid, OfTwoHalvesIsTheWhole) {
  const auto at = [](double x) { return Eigen::Affine3d(Eigen::Translation3d(x, 5, 0)); };
  const Solid halves = Mapped(BoxSolid({1, 2, 4}), at(0.5)) + Mapped(BoxSolid({3, 2, 4}), at(2.5));
  ExpectEqual(halves, Mapped(BoxSolid({4, 2, 4}), at(2)), 8 * kUlp);
}

TEST(Solid, MayHaveACavity) {
  Mesh mesh = Block();
  Mesh cavity = Moved(Block(), Eigen::Translation3d(0.25, 0.5, 1) * Eigen::Scaling(0.5));
  cavity.triangles.row(1).swap(cavity.triangles.row(2));
  Mesh hollow{.vertices = Eigen::Matrix3Xd(3, 16), .triangles = Eigen::Matrix3Xi(3, 24)};
  hollow.vertices << mesh.vertices, cavity.vertices;
  hollow.triangles << mesh.triangles, cavity.triangles.array() + 8;
  EXPECT_DOUBLE_EQ(MeshSolid(hollow).volume, 7);
}

/// The block's mesh, changed, must be refused with this reason.
void ExpectRefused(const std::function<void(Mesh&)>& change, const Finding& kind,
                   const std::vector<std::string>& words = {}) {
  Mesh mesh = Block();
  change(mesh);
  EXPECT_THAT([&] { MeshSolid(mesh); }, RefusesShape(kind, words));
}

TEST(Solid, NeedsAClosedMesh) {
  ExpectRefused([](Mesh& mesh) { mesh.triangles.conservativeResize(Eigen::NoChange, 11); }, kSurfaceOpen,
                {"(1 0 0) to (1 0 4)"});
}

TEST(Solid, NeedsTwoTrianglesAtEachEdge) {
  ExpectRefused(
      [](Mesh& mesh) {
        mesh.triangles.conservativeResize(Eigen::NoChange, 13);
        mesh.triangles.col(12) = mesh.triangles.col(11);
      },
      kSurfaceBranches, {"3", "(1 0 0) to (1 0 4)"});
}

TEST(Solid, NeedsOneOrientation) {
  ExpectRefused([](Mesh& mesh) { std::swap(mesh.triangles(1, 11), mesh.triangles(2, 11)); }, kSurfaceFlipped,
                {"(1 0 0) to (1 0 4)"});
}

TEST(Solid, NeedsToFaceOutward) {
  ExpectRefused([](Mesh& mesh) { mesh.triangles.row(1).swap(mesh.triangles.row(2)); }, kSurfaceInward);
}

TEST(Solid, NeedsAVolume) {
  // Thinner than single precision resolves.
  ExpectRefused([](Mesh& mesh) { mesh.vertices.row(0) *= 1e-9; }, kSurfaceFlat);
  ExpectRefused([](Mesh& mesh) { mesh.triangles.resize(Eigen::NoChange, 0); }, kSurfaceFlat);
  Mesh plate = Block();
  plate.vertices.row(0) *= 1e-4;
  EXPECT_DOUBLE_EQ(MeshSolid(plate).volume, 8e-4);
}

}  // namespace
}  // namespace fourpost::solid_test
