#include "vehicles/poses/one_axle.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/poses/suspension_rig.h"

namespace fourpost::one_axle_test {
namespace {

/// Poses at rest are found to 1e-11 of m and rad; loads are that times 1e6 N/m of stops and bushes.
constexpr double kSame = 1e-9;
constexpr double kSameLoad = 1e-3;

/// What an axle does in heave and under a lateral force, alone and on the whole car.
void ExpectAlike(const Vehicle& vehicle, std::size_t axle, double travel) {
  const std::vector<double> values = vehicle.ParameterValues();
  SuspensionRig whole(vehicle, values);
  const OneAxle alone = OneAxleOf(vehicle, whole.suspension(), axle);
  EXPECT_LT(alone.vehicle.links.size(), vehicle.links.size());
  SuspensionRig rig(alone.vehicle, values, alone.PreloadsOf(CondensedVehicle(vehicle).PreloadsAt(values)));
  const AxleTravel heave{.kind = AxleTravel::Kind::kHeave, .name = "heave", .stations = {}};
  const StationWants wants{.rates = false, .roll_centre = true};
  const std::vector<double> travels = {travel};
  const AxleStation expected = StationsAt(whole, axle, values, heave, travels, wants).front().value();
  const AxleStation found = StationsAt(rig, 0, values, heave, travels, wants).front().value();
  ASSERT_EQ(found.wheels.size(), expected.wheels.size());
  for (std::size_t k = 0; k < expected.wheels.size(); ++k) {
    EXPECT_NEAR(found.wheels[k].place.camber, expected.wheels[k].place.camber, kSame);
    EXPECT_NEAR(found.wheels[k].place.toe, expected.wheels[k].place.toe, kSame);
    EXPECT_NEAR((found.wheels[k].place.centre - expected.wheels[k].place.centre).norm(), 0, kSame);
    EXPECT_NEAR(found.wheels[k].load, expected.wheels[k].load, kSameLoad);
  }
  EXPECT_NEAR(found.roll_centre.value(), expected.roll_centre.value(), 1e-6);
  const std::vector<AxleCompliance> given = ComplianceOf(whole, axle, values);
  const std::vector<AxleCompliance> yields = ComplianceOf(rig, 0, values);
  ASSERT_EQ(yields.size(), given.size());
  // Metres per newton, of stiffnesses by differences.
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_NEAR(yields[i].wheels[0].centre.y(), given[i].wheels[0].centre.y(), 1e-12);
}

TEST(OneAxle, OfRigidLinksMovesAsOnTheWholeCar) {
  const Vehicle roadster = ShippedVehicle("independent_roadster");
  ExpectAlike(roadster, 0, 0.03);
  ExpectAlike(roadster, 1, -0.02);
}

TEST(OneAxle, OnRubberMovesAsOnTheWholeCar) { ExpectAlike(ShippedVehicle("landrover110"), 1, 0.02); }

}  // namespace
}  // namespace fourpost::one_axle_test
