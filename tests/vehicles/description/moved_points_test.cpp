#include "vehicles/description/moved_points.h"

#include <optional>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/poses/wishbone_on_rubber.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::moved_points_test {
namespace {

using axle_cars::RubberPoints;
using axle_cars::WishboneOnRubber;
using testing::ElementsAre;

constexpr const char* kParameter =
    "<fp:parameter name=\"d\" value=\"1 mm\" lower=\"-10 mm\" upper=\"10 mm\" precision=\"0.01 mm\" source=\"test\"/>\n"
    "<fp:parameter name=\"k\" value=\"2 kN/mm\" lower=\"1 kN/mm\" upper=\"4 kN/mm\" precision=\"1 N/mm\" "
    "source=\"test\"/>\n";

Vehicle Read(const RubberPoints& points) {
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicleText(WishboneOnRubber(points), "axle.urdf", findings);
  EXPECT_EQ(findings.Format(), "");
  return std::move(vehicle).value();
}

/// Shifted across and up by a parameter.
Vehicle Shifted() { return Read({.rate = "$k", .of_tie = "dy=\"$d\" dz=\"-0.5*$d\"", .tags = kParameter}); }

const Point& TieOf(const Vehicle& vehicle, const std::string& rod) {
  for (const Rod& one : vehicle.rods)
    if (one.name == rod) return one.child;
  throw std::out_of_range(rod);
}

/// Sums of decimals in m.
constexpr double kRounding = 1e-15;

TEST(MovedPoints, StandWhereTheFilesValueHasThem) {
  const Vehicle vehicle = Shifted();
  const Eigen::Vector3d drawn = axle_cars::kTrackRod.outer;
  EXPECT_NEAR((TieOf(vehicle, "track_rod_left").xyz - drawn - Eigen::Vector3d(0, 0.001, -0.0005)).norm(), 0, kRounding);
}

TEST(MovedPoints, GoWithTheirParameterAndBack) {
  const Vehicle vehicle = Shifted();
  const Vehicle moved = WithPointsAt(vehicle, std::vector<double>{-0.004, 3e6});
  const Eigen::Vector3d drawn = axle_cars::kTrackRod.outer;
  EXPECT_NEAR((TieOf(moved, "track_rod_left").xyz - drawn - Eigen::Vector3d(0, -0.004, 0.002)).norm(), 0, kRounding);
  const Vehicle back = WithPointsAt(moved, vehicle.ParameterValues());
  EXPECT_NEAR((TieOf(back, "track_rod_left").xyz - TieOf(vehicle, "track_rod_left").xyz).norm(), 0, kRounding);
}

TEST(MovedPoints, MirrorPartnersGoAsTheirImage) {
  const Vehicle moved = WithPointsAt(Shifted(), std::vector<double>{0.006, 2e6});
  const Eigen::Vector3d left = TieOf(moved, "track_rod_left").xyz;
  const Eigen::Vector3d right = TieOf(moved, "track_rod_right").xyz;
  EXPECT_NEAR((right - Eigen::Vector3d(left.x(), -left.y(), left.z())).norm(), 0, kRounding);
}

TEST(MovedPoints, AreKnownByTheirParameters) {
  EXPECT_THAT(MovePoints(Shifted()), ElementsAre(true, false));
  EXPECT_THROW(WithPointsAt(Shifted(), std::vector<double>{0}), std::invalid_argument);
}

TEST(MovedPoints, TakeLengthsOnly) {
  Diagnostics findings;
  EXPECT_FALSE(ReadVehicleText(WishboneOnRubber({.rate = "$k", .of_tie = "dz=\"$k\"", .tags = kParameter}), "axle.urdf",
                               findings));
  EXPECT_THAT(findings, Reports(kParameterOfOtherDimension, {"dz", "stiffness", "length"}));
}

}  // namespace
}  // namespace fourpost::moved_points_test
