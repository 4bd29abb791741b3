#include "vehicles/ride/body_motion.h"

#include <gtest/gtest.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/loops/design_kinematics.h"

namespace fourpost::body_motion_test {
namespace {

std::vector<BodyMotion> BodiesOf(const Vehicle& vehicle) {
  return BodyMotions(vehicle, DesignKinematics(vehicle), vehicle.ParameterValues());
}

/// The small vehicle, whose loops are for readers only.
const std::string kWithoutLoops =
    Replaced(Replaced(kSmallVehicle, R"(<fp:rod name="link" parent="top" child="ground"/>)", ""),
             R"(<fp:ball name="joint" parent="top" child="ground"/>)", "");

TEST(MassProperties, OfADumbBellAreThoseOfItsEnds) {
  const std::vector<MassProperties> ends = {{.mass = 2, .com = {0, 0.5, 1}}, {.mass = 1, .com = {0, 2, 1}}};
  const MassProperties whole = Joined(ends);
  EXPECT_EQ(whole.mass, 3);
  EXPECT_EQ(whole.com, Eigen::Vector3d(0, 1, 1));
  // 2 * 0.5^2 + 1 * 1^2, about all axes but its own.
  EXPECT_LT((whole.inertia - Eigen::Vector3d(1.5, 0, 1.5).asDiagonal().toDenseMatrix()).norm(), 1e-15);  // rounding
}

TEST(BodyMotions, TakeLinksThatAreFixedToEachOtherAsOne) {
  const Vehicle vehicle = VehicleOf(Replaced(kWithoutLoops, R"(type="continuous")", R"(type="fixed")"));
  const std::vector<BodyMotion> bodies = BodiesOf(vehicle);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].name, "body");
  EXPECT_EQ(bodies[0].links.size(), 2u);
  EXPECT_EQ(bodies[0].mass.mass, 222);
}

// A quarter turn about z takes x to y.
TEST(BodyMotions, TurnInertiaIntoGroundAxes) {
  const std::vector<BodyMotion> bodies = BodiesOf(VehicleOf(kWithoutLoops));
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_LT((bodies[1].mass.com - Eigen::Vector3d(0, 0.1, 1)).norm(), 1e-12);  // digits of pi / 2 in the file
  EXPECT_NEAR(bodies[1].mass.inertia(0, 0), 4, 1e-12);
  EXPECT_NEAR(bodies[1].mass.inertia(1, 1), 3, 1e-12);
}

// Products of inertia, loop closures and a centre of mass beside the link's origin.
TEST(BodyMotions, HaveTheKineticEnergyOfTheMassMatrix) {
  const Vehicle vehicle = ElementCar();
  const CondensedVehicle condensed(vehicle);
  const std::vector<BodyMotion> bodies = BodiesOf(vehicle);
  const Eigen::MatrixXd mass = condensed.At(vehicle.ParameterValues()).mass;
  for (int i = 0; i < condensed.size(); ++i) {
    Eigen::VectorXcd shape = Eigen::VectorXcd::Constant(condensed.size(), std::complex<double>(0.1, -0.3));
    shape[i] = std::complex<double>(1, 0.5);
    double energy = 0;
    for (const BodyMotion& body : bodies) energy += EnergyByDirection(body, shape).sum();
    const double expected = shape.dot(mass * shape).real();
    EXPECT_NEAR(energy, expected, 1e-12 * expected) << i;  // rounding
  }
}

}  // namespace
}  // namespace fourpost::body_motion_test
